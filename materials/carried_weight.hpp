// Laws that need the weight they carry.
#pragma once

#include <concepts>

#include "materials/response.hpp"

namespace moat {

/// Parameters of an isolator that become a law once the weight on it is known: a pendulum, a slider.
///
///     void check(const Check&) const
///     ForceLaw carrying(Force weight) const      weight > 0 N
///
/// A ShearBuilding gives its own weight; the field `weight` of such a struct overrides it.
template <class Design>
concept WeightBearing = requires(const Design& design, const Check& check, Force weight) {
  design.check(check);
  { design.weight } -> std::convertible_to<Force>;
  { design.carrying(weight) } -> ForceLaw;
};

/// The given weight, or else that of the building. Throws InputError where neither is known.
inline Force weight_on(const Check& check, Force given, Force of_building) {
  check.not_negative("weight", given);
  if (given.si() > 0.0) return given;
  check.positive("weight", of_building, "Give the weight that it carries; a ShearBuilding knows its own.");
  return of_building;
}

}  // namespace moat
