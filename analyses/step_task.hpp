// One time step to be taken.
#pragma once

#include <optional>

#include "base/plan_vector.hpp"
#include "motions/ground_span.hpp"

namespace moat {

/// A step from the committed state.
struct StepTask {
  double length = 0.0;                        ///< h > 0 s
  double end_time = 0.0;                      ///< s
  PlanVector ground_acceleration{};           ///< m/s^2, at the end
  PlanVector ground_jerk{};                   ///< m/s^3, mean of the step; used by schemes that correct the velocity
  PlanVector ground_acceleration_at_start{};  ///< m/s^2
  double start_time = 0.0;                    ///< s
  /// The motion of the ground over several samples; none where its acceleration is linear. Models in plan have none:
  /// their steps end at all samples.
  std::optional<GroundSpan> ground{};
};

}  // namespace moat
