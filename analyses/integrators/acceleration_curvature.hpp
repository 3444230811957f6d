// How accelerations curve from one step to the next.
#pragma once

#include <limits>

#include "analyses/time_history/step_method.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// Continues the accelerations of the step before into a step, better than their tangent at its start.
///
/// With y = h/H of both steps' lengths, the cubic through the absolute accelerations A0, A1 and jerks j0, j1 at the
/// start of the step before and of this one leaves the tangent at A1 by
///
///     y^2 (Q + 3 P + y (Q + 2 P)),   P = A0 - A1 + H j1,   Q = H (j0 - j1)
class AccelerationCurvature {
 public:
  /// The model must be prepared and outlive this object.
  explicit AccelerationCurvature(const AnalysisState& state);

  /// Adds this to a guess of the accelerations at the end of a step from the model's committed state, also of one that
  /// is tried again. Adds nothing where the last step given here did not end there, or was less than half as long.
  void add_to(Vector& guess, const StepTask& task);
  /// Accelerations may have jumped: the next step follows no other.
  void forget() { start_.time = unknown; }

 private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  // A committed state from which a step began.
  struct Start {
    double time = unknown;               // s
    GroundVector ground_acceleration{};  // m/s^2
    Vector acceleration, jerk;
  };

  const AnalysisState* state_;
  Start earlier_, start_;  // of the step before, its time unknown where it did not end here; and of this one
  double end_ = unknown;   // of the step given last, s
};

}  // namespace moat
