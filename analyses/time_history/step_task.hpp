// One time step to be taken.
#pragma once

#include "base/plan_vector.hpp"

namespace moat {

/// A step from the committed state.
struct StepTask {
  double length = 0.0;                        ///< h > 0 s
  double end_time = 0.0;                      ///< s
  PlanVector ground_acceleration{};           ///< m/s^2, at the end
  PlanVector ground_jerk{};                   ///< m/s^3, mean of the step; used by schemes that correct the velocity
  PlanVector ground_acceleration_at_start{};  ///< m/s^2
  double start_time = 0.0;                    ///< s
};

}  // namespace moat
