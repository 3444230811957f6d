#include "analyses/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moat {

StepEquations::StepEquations(Model& model, NewmarkScheme scheme) : model_{&model}, scheme_{scheme} {
  model.prepare();
  tangent_ = model.pattern();
  predicted_displacement_.setZero(size());
  predicted_velocity_.setZero(size());
  for (int i = 0; i < size(); ++i) diagonal_.push_back(static_cast<std::size_t>(tangent_.slot(i, i)));
}

void StepEquations::begin(double h, double end_time, double ground_acceleration) {
  h_ = h;
  ground_acceleration_ = ground_acceleration;
  const MotionState& start = model_->state();
  const double *u = start.displacement.data(), *v = start.velocity.data(), *a = start.acceleration.data();
  const double square = (0.5 - scheme_.beta) * h * h, first = (1.0 - NewmarkScheme::gamma) * h;
  double* __restrict displacement = predicted_displacement_.data();
  double* __restrict velocity = predicted_velocity_.data();
  for (int i = 0; i < size(); ++i) {
    displacement[i] = u[i] + h * v[i] + square * a[i];
    velocity[i] = v[i] + first * a[i];
  }
  model_->trial().time = end_time;
}

void StepEquations::balance_committed_state(double ground_acceleration) {
  MotionState& trial = model_->trial();
  trial = model_->state();
  model_->evaluate();
  const Vector& force = model_->internal_forces();
  const int count = size();
  trial.acceleration.head(count) =
      (-force.head(count).array() / model_->masses().array() - ground_acceleration).matrix();
  model_->commit();
}

bool StepEquations::compute_residual(const Vector& acceleration, Vector& residual) {
  const int count = size();
  MotionState& trial = model_->trial();
  const double displacement_weight = scheme_.displacement_weight(h_),
               velocity_weight = NewmarkScheme::velocity_weight(h_);
  const double *a = acceleration.data(), *predicted_displacement = predicted_displacement_.data(),
               *predicted_velocity = predicted_velocity_.data();
  double* __restrict trial_displacement = trial.displacement.data();
  double* __restrict trial_velocity = trial.velocity.data();
  double* __restrict trial_acceleration = trial.acceleration.data();
  for (int i = 0; i < count; ++i) {
    trial_acceleration[i] = a[i];
    trial_displacement[i] = predicted_displacement[i] + displacement_weight * a[i];
    trial_velocity[i] = predicted_velocity[i] + velocity_weight * a[i];
  }
  model_->evaluate();

  const double* mass = model_->masses().data();
  const double* force = model_->internal_forces().data();
  double* __restrict unbalanced = residual.data();
  double largest_inertia = 0.0, largest_force = 0.0, largest_mass = 0.0;
  for (int i = 0; i < count; ++i) {
    const double inertia = mass[i] * a[i];
    unbalanced[i] = inertia + force[i] + mass[i] * ground_acceleration_;
    largest_inertia = std::max(largest_inertia, std::abs(inertia));
    largest_force = std::max(largest_force, std::abs(force[i]));
    largest_mass = std::max(largest_mass, mass[i]);
  }
  // Each term alone passes through zero at some instant; the largest of them does not.
  scale_ = std::max({largest_inertia, largest_force, largest_mass * std::abs(ground_acceleration_)});
  return std::isfinite(scale_);
}

bool StepEquations::compute_direction(const Vector& residual, Vector& direction) {
  if (!factorised_ || h_ != factorised_step_ || model_->tangent_version() != factorised_version_) {
    model_->assemble_tangent(1.0, NewmarkScheme::velocity_weight(h_), scheme_.displacement_weight(h_), tangent_);
    factorised_ = factorisation_.factorise(tangent_);
    if (!factorised_) return false;
    factorised_step_ = h_;
    factorised_version_ = model_->tangent_version();
  }
  direction = -residual;
  factorisation_.solve(direction);
  return true;
}

double StepEquations::round_off() const {
  // A displacement is known to its last digit; stiffness times that is the force no iteration can balance. It shows
  // where net forces have died away but displacements have not: in the tail of a motion, beside very stiff links.
  constexpr double last_digits = 8.0 * std::numeric_limits<double>::epsilon();
  const double weight = scheme_.displacement_weight(h_);
  double largest = 0.0;
  for (int i = 0; i < size(); ++i) {
    const double stiffness = (tangent_.values[diagonal_[static_cast<std::size_t>(i)]] - model_->masses()[i]) / weight;
    largest = std::max(largest, last_digits * std::abs(stiffness * model_->trial().displacement[i]));
  }
  return largest;
}

}  // namespace moat
