// The exact motion of a linear system over one step.
#pragma once

#include <Eigen/Core>

#include "analyses/integrators/linear_system.hpp"
#include "analyses/time_history/step_method.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// The motion of a linear system over one step, under a ground acceleration that is linear in it. It follows by the
/// exponential of the system where the step has its length, else by the Taylor series from the start of the step.
class LinearPath {
 public:
  /// Begins at this state; `offset` is -M^-1 f0, m/s^2. The step is no longer than that of the system, which must exist
  /// until the next begin() or the end of the path.
  void begin(const LinearSystem& system, const Vector& offset, const MotionState& start, const StepTask& step);
  /// Moves to the time h s after the start, 0 <= h <= the length of the step: writes it, u, u', u'' and the absolute
  /// jerk -M^-1 (K u' + C u'').
  void move(double h, MotionState& motion);

 private:
  void go_inside(double share);

  const LinearSystem* system_ = nullptr;
  double start_time_ = 0.0;  // s
  Vector start_, there_;     // states of the system
  // Column k has the coefficients of (t/h)^k in the state, with h the step of the system.
  Eigen::MatrixXd series_;
  bool expanded_ = false;
};

}  // namespace moat
