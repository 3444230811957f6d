#include "analyses/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moat {

StepEquations::StepEquations(Model& model, NewmarkScheme scheme) : model_{&model}, scheme_{scheme} {
  model.prepare();
  tangent_ = model.pattern();
  forces_.setZero(size() + 1);
  for (int i = 0; i < size(); ++i) diagonal_.push_back(static_cast<std::size_t>(tangent_.slot(i, i)));
}

void StepEquations::begin(double h, double end_time, double ground_acceleration) {
  h_ = h;
  ground_acceleration_ = ground_acceleration;
  const MotionState& start = model_->state();
  predicted_displacement_ = start.displacement + h * start.velocity + (0.5 - scheme_.beta) * h * h * start.acceleration;
  predicted_velocity_ = start.velocity + (1.0 - NewmarkScheme::gamma) * h * start.acceleration;
  model_->trial().time = end_time;
}

void StepEquations::balance_committed_state(double ground_acceleration) {
  MotionState& trial = model_->trial();
  trial = model_->state();
  model_->evaluate();
  model_->internal_forces(forces_);
  const int count = size();
  trial.acceleration.head(count) =
      (-forces_.head(count).array() / model_->masses().array() - ground_acceleration).matrix();
  model_->commit();
}

bool StepEquations::compute_residual(const Vector& acceleration, Vector& residual) {
  const int count = size();
  MotionState& trial = model_->trial();
  trial.acceleration.head(count) = acceleration;
  trial.displacement.head(count) = predicted_displacement_.head(count) + scheme_.displacement_weight(h_) * acceleration;
  trial.velocity.head(count) = predicted_velocity_.head(count) + NewmarkScheme::velocity_weight(h_) * acceleration;
  model_->evaluate();
  model_->internal_forces(forces_);

  const double* mass = model_->masses().data();
  const double* force = forces_.data();
  double largest_inertia = 0.0, largest_force = 0.0, largest_mass = 0.0;
  for (int i = 0; i < count; ++i) {
    const double inertia = mass[i] * acceleration[i];
    residual[i] = inertia + force[i] + mass[i] * ground_acceleration_;
    largest_inertia = std::max(largest_inertia, std::abs(inertia));
    largest_force = std::max(largest_force, std::abs(force[i]));
    largest_mass = std::max(largest_mass, mass[i]);
  }
  // Each term alone passes through zero at some instant; the largest of them does not.
  scale_ = std::max({largest_inertia, largest_force, largest_mass * std::abs(ground_acceleration_)});
  return std::isfinite(scale_);
}

bool StepEquations::compute_direction(const Vector& residual, Vector& direction) {
  model_->assemble_tangent(1.0, NewmarkScheme::velocity_weight(h_), scheme_.displacement_weight(h_), tangent_);
  if (!factorisation_.factorise(tangent_)) return false;
  // A displacement is known to its last digit; stiffness times that is the force no iteration can balance. It shows
  // where net forces have died away but displacements have not: in the tail of a motion, beside very stiff links.
  constexpr double last_digits = 8.0 * std::numeric_limits<double>::epsilon();
  const double weight = scheme_.displacement_weight(h_);
  round_off_ = 0.0;
  for (int i = 0; i < size(); ++i) {
    const double stiffness = (tangent_.values[diagonal_[static_cast<std::size_t>(i)]] - model_->masses()[i]) / weight;
    round_off_ = std::max(round_off_, last_digits * std::abs(stiffness * model_->trial().displacement[i]));
  }
  direction = -residual;
  factorisation_.solve(direction);
  return true;
}

}  // namespace moat
