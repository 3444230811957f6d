#include "analyses/time_history/step_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace moat {
namespace {

// The first multiple of `step` after `time`, both in s; one that is closer than round-off is skipped.
double next_multiple(double time, double step) {
  const double position = time / step;
  const double coincident = std::max(1e-6, 8.0 * std::numeric_limits<double>::epsilon() * position);
  return static_cast<double>(static_cast<long>(position + coincident) + 1) * step;
}

}  // namespace

StepGrid::StepGrid(const GroundMotion& motion, double start, double end)
    : motion_{&motion}, end_{end}, ground_{motion.components_at(start)} {}

StepTask StepGrid::task(double start, double end, double length) const {
  StepTask step{.length = length, .end_time = end, .ground_acceleration_at_start = ground_, .start_time = start};
  if (!motion_ended_) step.ground_acceleration = motion_->components_at(end);
  step.ground_jerk = (1.0 / length) * (step.ground_acceleration - ground_);
  return step;
}

GroundVector StepGrid::rate_behind(double time) const {
  if (motion_ended_ || time >= motion_->duration()) return {};
  const double interval = motion_->time_step(), next = std::min(next_multiple(time, interval), motion_->duration());
  return (1.0 / interval) * (motion_->components_at(next) - motion_->components_at(next - interval));
}

StepTask StepGrid::next_step(double time, double length) const {
  double target = std::min(next_multiple(time, length), end_);
  if (!motion_ended_) target = std::min(target, motion_->duration());
  // Exactly the nominal length in the regular case, so that the tangent and its factors stay the same.
  const double exact = std::abs(target - time - length) < 1e-9 * length ? length : target - time;
  return task(time, target, exact);
}

StepTask StepGrid::first_part(const StepTask& step, double h) const {
  return task(step.start_time, step.start_time + h, h);
}

bool StepGrid::reaches_end_of_motion(double time) const {
  return !motion_ended_ && time >= motion_->duration() * (1.0 - 1e-12);
}

bool StepGrid::end_motion() {
  motion_ended_ = true;
  return std::exchange(ground_, GroundVector{}) != GroundVector{};
}

}  // namespace moat
