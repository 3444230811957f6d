// A building in plan, for tests.
#pragma once

#include "base/units.hpp"
#include "structures/plan_building.hpp"

namespace moat::testing {

/// Floors of 700 t on a base of 800 t, 20 x 12 m, without eccentricity: a column and a bearing at each corner.
inline PlanBuilding small_plan_building(int storeys, const LeadRubberBearing& bearing) {
  using namespace units;
  return {.outline = rectangle(20 * m, 12 * m),
          .storeys = storeys,
          .floor_mass = 700 * tonne,
          .columns = grid(2, 2, {.stiffness = 100 * MN / m}),
          .base_mass = 800 * tonne,
          .bearings = grid(2, 2, bearing)};
}

}  // namespace moat::testing
