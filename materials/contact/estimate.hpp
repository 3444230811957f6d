// A value with its range and its source.
#pragma once

#include <string>

namespace moat {

/// An estimate of a parameter. It converts to its value, so that it can be given where the parameter is:
///
///     .stiffness = contact_stiffness_of_slab_edge({.mass = 550 * tonne})
template <class Q>
struct Estimate {
  Q value{}, low{}, high{};        ///< low <= value <= high
  std::string source, assumption;  ///< Where the formula is from, and for which case it holds.

  operator Q() const { return value; }  ///< Returns the value.
};

}  // namespace moat
