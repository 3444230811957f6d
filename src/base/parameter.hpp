// A named number of a model, as reports print it.
#pragma once

#include <string_view>

namespace moat {

/// One parameter of a law, an element or an analysis. The texts are literals: they live as long as the program.
struct Parameter {
  std::string_view name;  ///< as scripts write it: "stiffness"
  double value = 0.0;     ///< in the unit; a choice between yes and no is 1 or 0
  std::string_view unit;  ///< SI: "N/m^1.5"; "1" without dimension

  friend bool operator==(const Parameter&, const Parameter&) = default;
};

}  // namespace moat
