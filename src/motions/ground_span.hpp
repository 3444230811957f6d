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

/// The motion of the ground at an instant inside a step, minus the cubics through its values and rates at both ends of
/// the step. An interpolated relative motion lacks this part.
struct GroundBump {
  double time = 0.0;                  ///< s
  double fraction = 0.0;              ///< of the step
  double displacement = 0.0;          ///< minus the cubic of displacement, m
  double rate_of_displacement = 0.0;  ///< minus the rate of that cubic, m/s
  double velocity = 0.0;              ///< minus the cubic of velocity, m/s
  double rate_of_velocity = 0.0;      ///< minus the rate of that cubic, m/s^2
};

/// A part of a motion: from `start` to `end`, 0 <= start < end <= motion.duration(), s. The motion must outlive it.
class GroundSpan {
 public:
  /// 0 <= start < end <= motion.duration(), s, which is not checked.
  GroundSpan(const GroundMotion& motion, double start, double end) : motion_{&motion}, start_{start}, end_{end} {
    constexpr double round_off = 1e-6;  // of an interval
    first_sample_ = static_cast<long>(start * motion.samples_per_second() + round_off) + 1;
    last_sample_ = static_cast<long>(end * motion.samples_per_second() - round_off);
    if (!is_straight()) find_line();
  }

  /// s
  [[nodiscard]] double start() const { return start_; }
  /// s
  [[nodiscard]] double length() const { return end_ - start_; }
  /// Whether the acceleration is linear in all of it.
  [[nodiscard]] bool is_straight() const { return first_sample_ > last_sample_; }
  /// m/s^2, at a time inside.
  [[nodiscard]] double acceleration_at(double time) const { return motion_->acceleration_at(time); }
  /// From the start to a time inside.
  [[nodiscard]] GroundDeviation deviation_at(double time) const { return path_to(time).sum; }
  /// At the end.
  [[nodiscard]] GroundDeviation deviation() const { return is_straight() ? GroundDeviation{} : deviation_at(end_); }
  /// At a time inside, s.
  [[nodiscard]] GroundBump bump_at(double time) const { return bump_at(path_to(time), deviation()); }
  /// No bump inside is larger than these.
  struct BumpBounds {
    double displacement = 0.0;  ///< m
    double velocity = 0.0;      ///< m/s
  };
  /// With the largest deviation d of a sample inside: d h^2/16 and d h/2. They cost far less than the bumps themselves.
  [[nodiscard]] BumpBounds bump_bounds() const;
  /// Calls visit(bump) at every sample strictly inside, in order.
  template <class Visit>
  void for_each_bump_inside(const Visit& visit) const;

 private:
  // The deviation integrated up to a time.
  struct Path {
    double time;
    double acceleration = 0.0;  // of the deviation, m/s^2
    GroundDeviation sum{};
    void advance(double to, double acceleration_there);
  };
  [[nodiscard]] Path path_to(double time) const;
  void advance_to_sample(Path& path, long sample) const;
  void find_line();
  [[nodiscard]] double deviation_of(double acceleration, double time) const {
    return acceleration - (start_acceleration_ + slope_ * (time - start_));
  }
  [[nodiscard]] GroundBump bump_at(const Path& path, const GroundDeviation& end) const;

  const GroundMotion* motion_;
  double start_, end_;
  long first_sample_, last_sample_;                // strictly inside; none where the first is beyond the last
  double start_acceleration_ = 0.0, slope_ = 0.0;  // of the straight line; unless the acceleration is one itself
};

template <class Visit>
void GroundSpan::for_each_bump_inside(const Visit& visit) const {
  const GroundDeviation end = deviation();
  Path path{start_};
  for (long sample = first_sample_; sample <= last_sample_; ++sample) {
    advance_to_sample(path, sample);
    visit(bump_at(path, end));
  }
}

}  // namespace moat
