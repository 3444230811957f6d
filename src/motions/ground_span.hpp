// The motion of the ground inside a step that is longer than the interval of its samples.
#pragma once

#include "motions/ground_motion.hpp"

namespace moat {

/// The acceleration of the ground over a step, minus the straight line between its values at both ends,
///
///     d(t) = a_g(t) - line(t),
///
/// integrated from the start of the step, exactly: between two samples d is linear. All are zero within one interval of
/// the samples.
struct GroundDeviation {
  double velocity = 0.0;               ///< integral of d, m/s
  double displacement = 0.0;           ///< integral of the above, m
  double displacement_integral = 0.0;  ///< integral of the above, m s
};

/// The motion of the ground at an instant inside a step, minus cubics through its values and rates at both ends. This
/// is what an interpolated relative motion lacks.
struct GroundBump {
  double time = 0.0;            ///< s
  double fraction = 0.0;        ///< of the step
  double displacement = 0.0;    ///< m
  double velocity = 0.0;        ///< minus the rate of the cubic of displacement, m/s
  double velocity_alone = 0.0;  ///< minus the cubic of velocity, m/s
  double acceleration = 0.0;    ///< minus the rate of the cubic of velocity, m/s^2
};

/// A part of a motion: from `start` to `end`, 0 <= start < end <= motion.duration(), s. The motion must outlive it.
class GroundSpan {
 public:
  GroundSpan(const GroundMotion& motion, double start, double end);

  /// s
  [[nodiscard]] double start() const { return start_; }
  [[nodiscard]] double length() const { return end_ - start_; }
  /// Whether the acceleration is linear in all of it.
  [[nodiscard]] bool is_straight() const { return first_sample_ > last_sample_; }
  /// m/s^2, at a time inside.
  [[nodiscard]] double acceleration_at(double time) const { return motion_->acceleration_at(time); }
  /// From the start to a time inside.
  [[nodiscard]] GroundDeviation deviation_at(double time) const;
  [[nodiscard]] GroundDeviation deviation() const { return is_straight() ? GroundDeviation{} : deviation_at(end_); }
  [[nodiscard]] GroundBump bump_at(double time) const { return bump_at(time, deviation_at(time), deviation()); }
  /// Number of samples inside, and the bump at each of them, counted from 0.
  [[nodiscard]] long samples_inside() const { return last_sample_ - first_sample_ + 1; }
  [[nodiscard]] GroundBump bump_at_sample(long index) const;
  /// Largest magnitude of the displacement's bump at the samples inside, m.
  [[nodiscard]] double largest_bump() const;

 private:
  [[nodiscard]] GroundBump bump_at(double time, const GroundDeviation& now, const GroundDeviation& end) const;

  const GroundMotion* motion_;
  double start_, end_;
  long first_sample_, last_sample_;  // strictly inside; none where the first is beyond the last
};

}  // namespace moat
