// The five-storey building on friction pendulums.
#pragma once

#include <string>
#include <utility>

#include "peers/building.hpp"

namespace moat::peers {

/// Coulomb friction of 5 % on a radius of 2.235 m, 1 mm of elastic move; no walls. The acceleration of the base, one of
/// Compared::impacts, has corners where the sliders stick; steps miss its peak.
inline Case on_pendulums(std::string name, const GroundMotion& motion, Compared compared = Compared::isolation) {
  Model model;
  const Building building = add(
      model, ShearBuilding{
                 .storeys = 5,
                 .floor_mass = paper::floor_mass,
                 .storey_stiffness = 1 * GN / m,
                 .damping = {.ratio = 0.05},
                 .base_mass = paper::base_mass,
                 .isolation = FrictionPendulum{.radius = 2.235 * m, .friction = 0.05, .yield_displacement = 1 * mm}});
  return {.name = std::move(name),
          .model = std::move(model),
          .base = building.base,
          .top = building.floor(5),
          .motion = motion,
          .end = motion.duration(),
          .compared = compared};
}

}  // namespace moat::peers
