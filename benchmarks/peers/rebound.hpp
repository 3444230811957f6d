// Free masses that rebound from a wall.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "peers/building.hpp"

namespace moat::peers {

/// Five masses of 550 t run into walls at 0.3 m/s. The distances differ, so that they touch at different phases of a
/// step. The values compared are their speeds afterwards; the exact ones are those that the law delivers.
template <class Law>
Case rebounds(std::string name, const Law& law) {
  constexpr double speed = 0.3, interval = 0.005, end = 0.4;  // m/s, s, s
  Model model;
  std::vector<NodeId> masses;
  for (const double clearance : {10.0, 10.37, 10.81, 11.26, 11.64}) {
    const std::string number = std::to_string(masses.size() + 1);
    masses.push_back(
        add(model, Node{.name = "mass " + number, .mass = paper::base_mass, .initial_velocity = speed * m / s}));
    add(model,
        Gap{.name = "wall " + number, .left = masses.back(), .right = ground, .clearance = clearance * mm, .law = law});
  }
  performance::Peaks exact{};
  exact.fill(speed * model.blocks().front()->delivered_restitution(0, speed));
  const std::size_t samples = static_cast<std::size_t>(end / interval) + 1;
  return {.name = std::move(name),
          .model = std::move(model),
          .base = masses.front(),
          .top = masses.back(),
          .motion = GroundMotion{"rest", interval, std::vector<double>(samples, 0.0)},
          .end = end,
          .compared = Compared::rebounds,
          .exact = exact};
}

}  // namespace moat::peers
