// Accidental eccentricity of the masses of a building in plan.
#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "structures/plan_building.hpp"

namespace moat {

PlanBuilding with_eccentricity(PlanBuilding building, double share_of_x, double share_of_y) {
  const Check check{"with_eccentricity", building.name};
  check.between("share_of_x", share_of_x, -0.5, 0.5, "1", "5 % is 0.05.");
  check.between("share_of_y", share_of_y, -0.5, 0.5, "1", "5 % is 0.05.");
  const PlanOutline& outline = building.outline;
  outline.check(check, "outline");
  const auto extent = [&](Length PlanPosition::*component) {
    const auto [low, high] = std::ranges::minmax(outline.corners, {}, component);
    return high.*component - low.*component;
  };
  const Length x = share_of_x * extent(&PlanPosition::x), y = share_of_y * extent(&PlanPosition::y);
  for (PlanPosition* offset : {&building.mass_offset, &building.base_mass_offset}) {
    offset->x += x;
    offset->y += y;
  }
  return building;
}

std::array<PlanBuilding, 4> accidental_eccentricities(const PlanBuilding& building, double share) {
  return {with_eccentricity(building, share, 0.0), with_eccentricity(building, -share, 0.0),
          with_eccentricity(building, 0.0, share), with_eccentricity(building, 0.0, -share)};
}

}  // namespace moat
