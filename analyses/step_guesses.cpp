// First guesses of the accelerations at the end of a step, better than the tangent at its start.
#include <utility>

#include "analyses/step_equations.hpp"

namespace moat {

// Whether the trial state of the last complete() was committed, or is tried again from the one before.
bool StepEquations::is_known(AtInstant& of_start, AtInstant& of_end) const {
  const double now = model_->state().time;
  if (of_end.time == now) std::swap(of_end, of_start);
  return of_start.time == now;
}

// From the guess a0, with forces that follow the committed tangents K and C from the committed state (u, v, f) on:
//
//     a = a0 - T^-1 (M a0 + f + K (u(a0) - u) + C (v(a0) - v) + M iota a_g)
void StepEquations::extrapolate(Vector& guess) {
  if (linear_version_ != factorised_version_) {
    if (stiffness_.size() == 0) stiffness_ = damping_ = model_->pattern();
    model_->assemble_tangent(0.0, 0.0, 1.0, stiffness_);
    model_->assemble_tangent(0.0, 1.0, 0.0, damping_);
    linear_version_ = factorised_version_;
  }
  const int count = size();
  const double displacement_weight = factorised_displacement_weight_, velocity_weight = factorised_velocity_weight_;
  const MotionState& start = model_->state();
  const double *a = guess.data(), *u = start.displacement.data(), *v = of_committed_.values.data(),
               *mass = model_->masses().data(), *force = model_->committed_forces().data(),
               *predicted_displacement = predicted_displacement_.data(),
               *predicted_velocity = predicted_velocity_.data();
  const GroundShares shares = model_->ground_shares();
  unbalanced_.resize(count);
  double* __restrict unbalanced = unbalanced_.data();
  for (int i = 0; i < count; ++i)
    unbalanced[i] = -(mass[i] * (a[i] + shares.of(task_.ground_acceleration, i)) + force[i]);
  const int *starts = stiffness_.column_starts().data(), *rows = stiffness_.row_indices().data();
  const double *stiffness = stiffness_.values.data(), *damping = damping_.values.data();
  for (int i = 0; i < count; ++i) {
    const double du = predicted_displacement[i] + displacement_weight * a[i] - u[i],
                 dv = predicted_velocity[i] + velocity_weight * a[i] - v[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k) unbalanced[rows[k]] -= stiffness[k] * du + damping[k] * dv;
  }
  factorisation_.solve(unbalanced_);
  guess += unbalanced_;
}

}  // namespace moat
