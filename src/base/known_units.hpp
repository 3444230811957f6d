// Units by their names.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "base/units.hpp"

namespace moat {

/// A unit with its value in SI and its dimension (base/quantity.hpp).
struct KnownUnit {
  std::string_view name;                    ///< as people write it: "kN"
  double si = 1.0;                          ///< of one of it
  int mass = 0, half_length = 0, time = 0;  ///< exponents
};

/// From a constant of namespace units.
template <class Q>
constexpr KnownUnit known_unit(std::string_view name, Q unit) {
  return {name, unit.si(), Q::mass_exponent, Q::half_length_exponent, Q::time_exponent};
}

/// These units have the same name in scripts and on the command line.
inline constexpr std::array common_units{
    known_unit("m", units::m),   known_unit("mm", units::mm),       known_unit("cm", units::cm),
    known_unit("km", units::km), known_unit("s", units::s),         known_unit("ms", units::ms),
    known_unit("kg", units::kg), known_unit("tonne", units::tonne), known_unit("N", units::N),
    known_unit("kN", units::kN), known_unit("MN", units::MN),       known_unit("GN", units::GN),
    known_unit("J", units::J),   known_unit("kJ", units::kJ),       known_unit("MJ", units::MJ),
    known_unit("Hz", units::Hz), known_unit("g", units::g)};

/// These, and others behind them.
template <std::size_t others>
constexpr auto common_units_and(const std::array<KnownUnit, others>& more) {
  std::array<KnownUnit, common_units.size() + others> all{};
  std::ranges::copy(more, std::ranges::copy(common_units, all.begin()).out);
  return all;
}

}  // namespace moat
