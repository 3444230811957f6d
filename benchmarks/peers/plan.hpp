// A building in plan on lead-rubber bearings that stand off the middle.
#pragma once

#include <string>
#include <utility>

#include "peers/building.hpp"

namespace moat::peers {

/// Base and three floors with their centres of mass above each other on four bearings, whose middle is 1 m and 0.6 m
/// beside them; every bearing yields on a circle. The second component of the motion is 0.8 times the first one, 0.5 s
/// later: the motion runs on curves.
inline Case on_bearings_in_plan(std::string name, const GroundMotion& motion) {
  const LeadRubberBearing bearing{
      .yield_force = 0.35 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 3.5 * MN / m};
  const auto at = [&](double x, double y) {
    return PlanBearings::Placed{PlanPosition{(1.0 + x) * m, (0.6 + y) * m}, bearing};
  };
  Model model;
  const PlanBuildingParts building =
      add(model, PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                              .storeys = 3,
                              .floor_mass = paper::floor_mass,
                              .columns = StoreyStiffness{.x = 1 * GN / m, .y = 0.8 * GN / m, .rotation = 40 * GN * m},
                              .damping = {.ratio = 0.05},
                              .base_mass = paper::base_mass,
                              .bearings = {at(-8, -5), at(8, -5), at(-8, 5), at(8, 5)}});
  const auto delay = static_cast<std::size_t>(0.5 / motion.time_step());
  std::vector<double> second(motion.samples().size(), 0.0);
  for (std::size_t i = delay; i < second.size(); ++i) second[i] = 0.8 * motion.samples()[i - delay];
  return {.name = std::move(name),
          .model = std::move(model),
          .base = building.base,
          .top = building.floor(3),
          .motion = motion.with_component_y(std::move(second), motion, motion),
          .end = motion.duration(),
          .compared = Compared::plan};
}

}  // namespace moat::peers
