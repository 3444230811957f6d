// A rigid block on bearings at three places of a line, and motions that shake it along the line and up.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// A block of 1200 t, `height` m above bearings at -4, 0 and 4 m: `count` of them at each place, one by one or together
/// as one Isolator. The building goes on where it rocks.
template <class Law>
Model block_on(const Law& law, double height, int count = 1, bool together = false, AxialForces forces = {}) {
  using namespace units;
  forces.base_height = height * m;
  forces.rocking = AxialForces::Rocking::continues;
  constexpr double mass = 1.2e6, gravity = 9.80665;  // kg, m/s^2
  Model model;
  const NodeId node = add(model, Node{.name = "block", .mass = mass * kg});
  for (const double at : {-4.0, 0.0, 4.0})
    for (int i = 0; i < (together ? 1 : count); ++i)
      add(model, Isolator<Law>{.name = "at " + std::to_string(at) + " " + std::to_string(i),
                               .upper = node,
                               .law = law,
                               .count = together ? count : 1,
                               .weight = mass * gravity / (together ? 3.0 : 3.0 * count) * N,
                               .at = at * m,
                               .weight_changes = true});
  add(model, Building{.name = "block", .base = node, .axial_forces = forces});
  return model;
}

/// Six seconds along the line, of a size of 1 m/s^2 times `along`, with a vertical acceleration of 7 Hz and the
/// amplitude `up` m/s^2. Above g the block flies for parts of each cycle.
inline GroundMotion shaking_along_and_up(double along, double up) {
  std::vector<double> horizontal, vertical;
  for (int i = 0; i <= 300; ++i) {
    horizontal.push_back(along * (std::sin(0.02 * i * 2.4) + 0.4 * std::sin(0.02 * i * 9.0)));
    vertical.push_back(up * std::sin(i * 0.9));
  }
  return with_vertical({"push", 0.02, horizontal}, {"up", 0.02, vertical});
}

}  // namespace moat::testing
