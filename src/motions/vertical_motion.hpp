// The vertical acceleration of a building on the ground.
#pragma once

#include <cstddef>
#include <vector>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Absolute vertical acceleration a_v of a mass under the vertical component a_gv of a motion, m/s^2, up positive. It
/// follows the ground, a_v = a_gv, or it vibrates on the ground in one mode:
///
///     w'' + 2 z o w' + o^2 w = -a_gv,   a_v = w'' + a_gv = -(2 z o w' + o^2 w),   o = 2 pi/period,  z = damping ratio
///
/// The mode is exact at any time: a_gv is linear between samples, and 0 after the last one. Before time 0 all is at
/// rest. Without a vertical component a_v is 0.
class VerticalMotion {
 public:
  /// The side of a time at which a rate is taken.
  enum class Side { before, after };

  /// period: 0 s, or > 0 s for one mode. 0 <= damping_ratio < 1, of the mode.
  VerticalMotion(const GroundMotion& motion, Time period, double damping_ratio);

  /// a_v at a time, s; m/s^2. At the end of the motion that of its last sample.
  [[nodiscard]] double acceleration(double time) const;
  /// da_v/dt on one side of a time, m/s^3. A time within 1e-8 of the interval of samples from a sample counts as that
  /// of the sample.
  [[nodiscard]] double rate(double time, Side side) const;
  /// Whether the rate jumps at the samples: no step may reach across one.
  [[nodiscard]] bool kinks_at_samples() const { return frequency_ == 0.0 && !ground_.empty(); }
  /// Steps that follow the mode, s: a twentieth of its period. Infinite without one.
  [[nodiscard]] double longest_step() const;

 private:
  // The mode: o^2 w and its rate.
  struct State {
    double value = 0.0, rate = 0.0;
  };
  // A time: the time since the last sample, and the ground's acceleration then, with its rate.
  struct Instant {
    std::size_t sample = 0;
    double since = 0.0, ground = 0.0, ground_rate = 0.0;
    bool before = false;  // all samples
  };
  [[nodiscard]] Instant instant(double time, Side side) const;
  [[nodiscard]] State state(const Instant& at) const;
  [[nodiscard]] State later(const State& start, double load, double load_rate, double time) const;

  std::vector<double> ground_;
  double interval_;
  double frequency_;  // o; 0 without a mode
  double damping_ratio_;
  std::vector<State> states_{};  // at the samples; empty without a mode
};

}  // namespace moat
