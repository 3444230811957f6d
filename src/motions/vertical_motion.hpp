// The vertical acceleration of a building on the ground.
#pragma once

#include <cstddef>
#include <vector>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Absolute vertical acceleration a_v of a mass that vibrates in one mode on the ground, under the vertical component
/// a_gv of its motion, m/s^2, up positive:
///
///     w'' + 2 z o w' + o^2 w = -a_gv,   a_v = w'' + a_gv = -(2 z o w' + o^2 w),   o = 2 pi/period,  z = damping ratio
///
/// Exact at any time: a_gv is linear between samples, and 0 after the last one. Before time 0 all is at rest. Without a
/// vertical component a_v is 0.
class VerticalMotion {
 public:
  /// period > 0 s; 0 <= damping_ratio < 1.
  VerticalMotion(const GroundMotion& motion, Time period, double damping_ratio);

  /// a_v at a time, s; m/s^2.
  [[nodiscard]] double acceleration(double time) const;
  /// da_v/dt behind a time, m/s^3. A time within 1e-8 of the interval of samples from a sample counts as that of the
  /// sample.
  [[nodiscard]] double rate(double time) const;
  /// Steps that follow the mode, s: a twentieth of its period.
  [[nodiscard]] double longest_step() const;

 private:
  // The mode: o^2 w and its rate.
  struct State {
    double value = 0.0, rate = 0.0;
  };
  // The mode at a time, with the ground's acceleration then.
  struct Instant {
    State mode{};
    double ground = 0.0;
  };
  [[nodiscard]] Instant instant(double time) const;
  [[nodiscard]] double acceleration(const State& mode) const;
  [[nodiscard]] State later(const State& start, double load, double load_rate, double time) const;

  std::vector<double> ground_;
  double interval_;
  double frequency_;  // o
  double damping_ratio_;
  std::vector<State> states_;  // at the samples
};

}  // namespace moat
