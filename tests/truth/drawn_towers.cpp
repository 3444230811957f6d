// Towers in plan drawn at random.
#include <utility>

#include "drawn_buildings.hpp"
#include "random_draws.hpp"
#include "random_tower.hpp"
#include "scaled_mass.hpp"

namespace moat::testing {

using namespace units;

namespace {

// One of the laws that a bearing in plan can have; the building gives weights.
PlanBearings::Placed bearing_in_plan(int law, PlanPosition at, double mass) {
  const auto placed = [&](auto design, double size) {
    scale_mass(design, size * mass);
    return PlanBearings::Placed{at, design};
  };
  switch (law) {
    case 0:
      return placed(FrictionPendulum::typical(), 1.0);
    case 1:
      return placed(FlatSlider{.friction = 0.05, .restoring_stiffness = 1 * MN / m}, 1.0);
    case 2:
      return placed(DoublePendulum::typical(), 1.0);
    case 3:
      return placed(TriplePendulum::typical(), 1.0);
    default:
      return placed(GrantRubber::typical(), 8.0);
  }
}

}  // namespace

Problem tower_in_plan(const Draw& draw, const View& view) {
  RandomDraws numbers{draw.seed ^ 0x706c616eU};
  TowerOptions options{.turn = view.turn, .walls = draw.walls, .mass = view.mass, .reversed = view.reversed};
  const int law = numbers.integer(-4, 4);
  const bool overturns = numbers.chance(0.5);
  if (law >= 0) options.bearing = [=, &view](PlanPosition at) { return bearing_in_plan(law, at, view.mass); };
  if (law >= 0 && law < 4 && overturns) options.axial_forces = AxialForces{.base_height = 1 * m};
  Tower tower = random_tower(static_cast<unsigned>(draw.seed), options);
  return {std::move(tower.model), std::move(tower.motion), draw.duration * s};
}

}  // namespace moat::testing
