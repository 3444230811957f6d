// Small models and motions that many tests begin with.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// The samples of an acceleration of the ground, m/s^2, as a function of time in s, from 0 s on.
template <class Acceleration>
GroundMotion sampled(const std::string& name, Time duration, Time time_step, Acceleration acceleration) {
  const auto intervals = static_cast<int>(std::lround(duration / time_step));
  std::vector<double> samples;
  for (int i = 0; i <= intervals; ++i) samples.push_back(acceleration(time_step.si() * i));
  return GroundMotion{name, time_step.si(), std::move(samples)};
}

/// A ground that does not move, for analyses that start from initial values.
inline GroundMotion still_ground(Time duration, Time time_step = 10 * units::ms) {
  return sampled("still ground", duration, time_step, [](double) { return 0.0; });
}

/// A mass on a spring from the ground, beside a dashpot unless the damping ratio is zero.
struct Oscillator {
  std::string name = "body";
  double mass = 1e5;                          ///< kg
  double frequency = 2.0 * std::numbers::pi;  ///< angular, 1/s
  double damping_ratio = 0.0;                 ///< of critical damping
  double displacement = 0.0, velocity = 0.0;  ///< m and m/s, at the start

  [[nodiscard]] double stiffness() const { return mass * frequency * frequency; }
};

/// Adds a node of the given name with "NAME spring" and "NAME damper".
inline NodeId add(Model& model, const Oscillator& given) {
  using namespace units;
  const NodeId node = add(model, Node{.name = given.name,
                                      .mass = given.mass * kg,
                                      .initial_displacement = given.displacement * m,
                                      .initial_velocity = given.velocity * m / s});
  add(model,
      ShearSpring{
          .name = given.name + " spring", .lower = ground, .upper = node, .stiffness = given.stiffness() * N / m});
  if (given.damping_ratio > 0.0)
    add(model, ViscousDamper{.name = given.name + " damper",
                             .lower = ground,
                             .upper = node,
                             .damping = 2.0 * given.damping_ratio * given.mass * given.frequency * N * s / m});
  return node;
}

inline Model oscillator(const Oscillator& given) {
  Model model;
  add(model, given);
  return model;
}

/// A free body, kg, that moves with a speed, m/s, towards "wall" on its right, a clearance of so many m away.
template <class Law>
Model body_before_wall(const Law& law, double mass, double speed, double clearance) {
  using namespace units;
  Model model;
  const NodeId body =
      add(model, Node{.name = "body", .mass = mass * kg, .initial_velocity = speed * m / s, .free = true});
  add(model, Gap<Law>{.name = "wall", .left = body, .right = ground, .clearance = clearance * m, .law = law});
  return model;
}

}  // namespace moat::testing
