// Where steps end.
#pragma once

#include "analyses/time_history/step_method.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// The times at which steps end: multiples of their length, the end of the motion, and the end of the analysis; and the
/// ground's acceleration there. Grid times are multiples of the step and not sums of steps, so that the last sample is
/// not passed by round-off.
class StepGrid {
 public:
  /// `motion` must outlive this object. `start` < `end`, s.
  StepGrid(const GroundMotion& motion, double start, double end);

  /// s
  [[nodiscard]] double end() const { return end_; }
  /// Whether a time in s is the end, but for round-off.
  [[nodiscard]] bool finished(double time) const { return time >= end_ * (1.0 - 1e-12); }
  /// The ground's acceleration at the committed state, m/s^2.
  [[nodiscard]] GroundVector ground_acceleration() const { return ground_; }

  /// The rate of the ground's acceleration, m/s^3, between the samples around the instant just behind a time in s.
  [[nodiscard]] GroundVector rate_behind(double time) const;

  /// The step from `time` to the next multiple of `length`, s.
  [[nodiscard]] StepTask next_step(double time, double length) const;
  /// The first h seconds of a step that next_step() returned.
  [[nodiscard]] StepTask first_part(const StepTask& step, double h) const;
  /// The step was accepted.
  void accepted(const StepTask& step) { ground_ = step.ground_acceleration; }

  /// Whether the last sample is reached and end_motion() was not called yet.
  [[nodiscard]] bool reaches_end_of_motion(double time) const;
  /// After its last sample the ground is at rest. Its acceleration jumps to zero; it does not decrease linearly. False
  /// if it is zero already.
  bool end_motion();
  /// Writes or reads the ground at the committed state.
  void archive(auto& archive) { archive(ground_, motion_ended_); }

 private:
  [[nodiscard]] StepTask task(double start, double end, double length) const;

  const GroundMotion* motion_;
  double end_;
  GroundVector ground_;
  bool motion_ended_ = false;
};

}  // namespace moat
