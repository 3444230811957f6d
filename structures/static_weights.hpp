// The weights that bearings carry at rest.
#pragma once

#include <string>
#include <vector>

#include "base/check.hpp"
#include "model/model.hpp"
#include "model/weight/axial_forces.hpp"

namespace moat {

/// A bearing, or equal ones at one place, as the sharing of a weight needs it.
struct BearingPlace {
  PlanVector at{};                 ///< m
  Force own_weight{};              ///< > 0 N where it is given.
  Stiffness vertical_stiffness{};  ///< > 0 N/m where it is given.
  int count = 1;                   ///< of equal bearings side by side
};

/// Returns the weight at rest of every bearing of a building, whose centre of mass is at `centre`, m: those given, else
/// shares of its weight. Throws InputError where some but not all have a weight or a vertical stiffness of their own,
/// weights that miss that of the building by more than 1e-6 of it, and where it would tip at rest.
std::vector<Force> static_weights(const Check& check, const AxialForces& options,
                                  const std::vector<BearingPlace>& bearings, Force weight, PlanVector centre,
                                  bool in_plan);

/// Checks options of a building that stands on bearings. Throws InputError.
void check_axial_forces(const Check& check, const AxialForces& options, bool heights_are_given);

}  // namespace moat
