#include "analyses/integrators/acceleration_curvature.hpp"

#include <utility>

#include "analyses/time_history/equation_of_motion.hpp"

namespace moat {

AccelerationCurvature::AccelerationCurvature(const AnalysisState& state) : state_{&state} {
  // Only room, so that steps need not ask for it.
  for (Start* start : {&earlier_, &start_}) start->acceleration = start->jerk = state.motion().jerk;
}

void AccelerationCurvature::add_to(Vector& guess, const StepTask& task) {
  const MotionState& now = state_->motion();
  if (start_.time != now.time) {
    std::swap(earlier_, start_);
    if (end_ != now.time) earlier_.time = unknown;
    start_.time = now.time;
    start_.ground_acceleration = task.ground_acceleration_at_start;
    start_.acceleration = now.acceleration;
    start_.jerk = now.jerk;
  }
  end_ = task.end_time;
  const double length = start_.time - earlier_.time, y = task.length / length;
  // A continuation farther than this, in lengths of the step before, is no better than the tangent.
  constexpr double longest = 2.0;
  // Without a step before, y is no number.
  if (!(y <= longest)) return;
  const double *a0 = earlier_.acceleration.data(), *j0 = earlier_.jerk.data(), *a1 = start_.acceleration.data(),
               *j1 = start_.jerk.data();
  double* __restrict first = guess.data();
  with_ground_component(state_->model(), earlier_.ground_acceleration - start_.ground_acceleration,
                        [&, count = state_->model().degrees_of_freedom()](const auto& of_ground) {
                          for (int i = 0; i < count; ++i) {
                            const double p = a0[i] - a1[i] + of_ground(i) + length * j1[i],
                                         q = length * (j0[i] - j1[i]);
                            first[i] += y * y * (q + 3.0 * p + y * (q + 2.0 * p));
                          }
                        });
}

}  // namespace moat
