#include "analyses/step_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace moat {
namespace {

// The first multiple of `step` after `time`; one that is closer than round-off is skipped.
double next_grid_time(double time, double step) {
  const double position = time / step;
  const double coincident = std::max(1e-6, 8.0 * std::numeric_limits<double>::epsilon() * position);
  return (std::floor(position + coincident) + 1.0) * step;
}

}  // namespace

StepGrid::StepGrid(const GroundMotion& motion, double start, double end)
    : motion_{&motion}, end_{end}, ground_{motion.acceleration_at(start)} {}

StepTask StepGrid::next_step(double time, double length) const {
  double target = std::min(next_grid_time(time, length), end_);
  if (!motion_ended_) target = std::min(target, motion_->duration());
  // Exactly the nominal length in the regular case, so that the tangent and its factors stay the same.
  const double exact = std::abs(target - time - length) < 1e-9 * length ? length : target - time;
  const double at_end = motion_ended_ ? 0.0 : motion_->acceleration_at(target);
  return {exact, target, at_end, (at_end - ground_) / exact, ground_, time};
}

StepTask StepGrid::first_part(const StepTask& step, double h) const {
  if (h == step.length) return step;
  const double end = step.start_time + h;
  return {h, end, motion_ended_ ? 0.0 : motion_->acceleration_at(end), step.ground_jerk, ground_, step.start_time};
}

bool StepGrid::reaches_end_of_motion(double time) const {
  return !motion_ended_ && time >= motion_->duration() * (1.0 - 1e-12);
}

bool StepGrid::end_motion() {
  motion_ended_ = true;
  return std::exchange(ground_, 0.0) != 0.0;
}

}  // namespace moat
