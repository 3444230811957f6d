// The free impact of two bodies, through the whole analysis.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "moat.hpp"

namespace moat::testing {

struct Collision {
  double left_mass, right_mass;  ///< kg
  double approach_speed;         ///< m/s
  double phase = 0.37;           ///< of arrival, in intervals of the motion

  [[nodiscard]] double effective_mass() const { return left_mass * right_mass / (left_mass + right_mass); }
};

/// Restitution in the impact of two free bodies; the ground is still and sampled at a quarter of the contact.
template <class Law>
double delivered(const Law& law, const Collision& collision, const TransientOptions& options = {}) {
  using namespace units;
  const double effective_mass = collision.effective_mass();
  const double interval = 0.25 * law.between(effective_mass).contact_duration(effective_mass, collision.approach_speed);
  Model model;
  const NodeId left = add(model, Node{.name = "left",
                                      .mass = collision.left_mass * kg,
                                      .initial_velocity = 0.75 * collision.approach_speed * m / s});
  const NodeId right = add(model, Node{.name = "right",
                                       .mass = collision.right_mass * kg,
                                       .initial_velocity = -0.25 * collision.approach_speed * m / s});
  const double clearance = (3.0 + collision.phase) * interval * collision.approach_speed;
  add(model, Gap<Law>{.name = "gap", .left = left, .right = right, .clearance = clearance * m, .law = law});
  Transient analysis{model, GroundMotion{"still ground", interval, std::vector<double>(4001, 0.0)}, options};
  ImpactRecorder impacts;
  analysis.attach(impacts);
  while (!analysis.finished() && (impacts.impacts().empty() || impacts.impacts().front().duration == 0.0))
    analysis.advance();
  if (impacts.impacts().size() != 1) return std::nan("");
  EXPECT_NEAR(impacts.impacts().front().approach_speed, collision.approach_speed, 1e-9 * collision.approach_speed);
  return impacts.impacts().front().rebound_ratio;
}

}  // namespace moat::testing
