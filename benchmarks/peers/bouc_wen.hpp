// Five storeys with Bouc-Wen hysteresis on the ground.
#pragma once

#include <string>
#include <utility>

#include "peers/building.hpp"

namespace moat::peers {

/// Every storey yields at a quarter of the weight and keeps 5 % of its stiffness; the corner has n = 2.
inline Case bouc_wen_storeys(std::string name, const GroundMotion& motion) {
  Model model;
  const Building building = add(model, ShearBuilding{.storeys = 5,
                                                     .floor_mass = paper::floor_mass,
                                                     .storey = BoucWen{.yield_force = 6 * MN,
                                                                       .yield_displacement = 6 * mm,
                                                                       .post_yield_stiffness = 50 * MN / m},
                                                     .damping = {.ratio = 0.05}});
  return {.name = std::move(name),
          .model = std::move(model),
          .base = building.floor(1),
          .top = building.floor(5),
          .motion = motion,
          .end = motion.duration()};
}

}  // namespace moat::peers
