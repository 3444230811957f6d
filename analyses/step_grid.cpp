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
  return static_cast<double>(static_cast<long>(position + coincident) + 1) * step;
}

}  // namespace

StepGrid::StepGrid(const GroundMotion& motion, double start, double end)
    : motion_{&motion}, end_{end}, ground_{motion.components_at(start)} {}

StepTask StepGrid::next_step(double time, double length) const {
  double target = std::min(next_grid_time(time, length), end_);
  if (!motion_ended_) target = std::min(target, motion_->duration());
  // Exactly the nominal length in the regular case, so that the tangent and its factors stay the same.
  const double exact = std::abs(target - time - length) < 1e-9 * length ? length : target - time;
  return task(time, target, exact);
}

StepTask StepGrid::task(double start, double end, double length) const {
  const PlanVector at_end = motion_ended_ ? PlanVector{} : motion_->components_at(end);
  StepTask step{length, end, at_end, (at_end - ground_) / length, ground_, start};
  if (!motion_->has_two_components()) step.ground_deviation = span(start, end).deviation();
  return step;
}

void StepGrid::accepted(const StepTask& step) {
  ground_ = step.ground_acceleration;
  span_ = span(step.start_time, step.end_time);
  if (span_->is_straight()) span_.reset();
}

GroundSpan StepGrid::span(double start, double end) const {
  return motion_ended_ ? GroundSpan{*motion_, end, end} : GroundSpan{*motion_, start, end};
}

StepTask StepGrid::first_part(const StepTask& step, double h) const {
  return task(step.start_time, step.start_time + h, h);
}

bool StepGrid::reaches_end_of_motion(double time) const {
  return !motion_ended_ && time >= motion_->duration() * (1.0 - 1e-12);
}

bool StepGrid::end_motion() {
  motion_ended_ = true;
  return std::exchange(ground_, PlanVector{}) != PlanVector{};
}

}  // namespace moat
