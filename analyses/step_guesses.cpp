// First guesses of the accelerations at the end of a step, better than the tangent at its start.
#include <limits>
#include <utility>

#include "analyses/ground_component.hpp"
#include "analyses/step_equations.hpp"

namespace moat {

// Whether the trial state of the last complete() was committed, or is tried again from the one before.
bool StepEquations::knows_velocity_of_forces() {
  const double now = model_->state().time;
  if (of_trial_.time == now) std::swap(of_trial_, of_committed_);
  return of_committed_.time == now;
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
  const double *a = guess.data(), *u = start.displacement.data(), *v = of_committed_.velocity.data(),
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

// With y = h/H of both steps' lengths, the cubic through the absolute accelerations A0, A1 and jerks j0, j1 at the
// start of the step before and of this one leaves the tangent at A1 by
//
//     y^2 (Q + 3 P + y (Q + 2 P)),   P = A0 - A1 + H j1,   Q = H (j0 - j1)
void StepEquations::add_curvature(bool follows_last_step, Vector& guess) {
  const MotionState& now = model_->state();
  if (start_.time != now.time) {
    std::swap(earlier_, start_);
    start_.time = now.time;
    start_.ground_acceleration = task_.ground_acceleration_at_start;
    start_.acceleration = now.acceleration;
    start_.jerk = now.jerk;
    if (!follows_last_step) earlier_.time = std::numeric_limits<double>::quiet_NaN();
  }
  const double length = start_.time - earlier_.time, y = task_.length / length;
  constexpr double longest =
      2.0;  // of the step before: an extrapolation farther than that is no better than the tangent
  // Without a step before, y is no number.
  if (!(y <= longest)) return;
  const double *a0 = earlier_.acceleration.data(), *j0 = earlier_.jerk.data(), *a1 = start_.acceleration.data(),
               *j1 = start_.jerk.data();
  double* __restrict first = guess.data();
  with_ground_component(
      *model_, earlier_.ground_acceleration - start_.ground_acceleration, [&, count = size()](const auto& of_ground) {
        for (int i = 0; i < count; ++i) {
          const double p = a0[i] - a1[i] + of_ground(i) + length * j1[i], q = length * (j0[i] - j1[i]);
          first[i] += y * y * (q + 3.0 * p + y * (q + 2.0 * p));
        }
      });
}

}  // namespace moat
