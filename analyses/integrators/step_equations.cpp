#include "analyses/integrators/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "model/equation_of_motion.hpp"

namespace moat {

StepEquations::StepEquations(AnalysisState& state) : state_{&state}, resultants_{state.model()} {
  tangent_ = state.zero_matrix();
  predicted_displacement_.setZero(size());
  predicted_velocity_.setZero(size());
  scales_.setZero(size());
  balanced_scales_.setZero(size());
}

void StepEquations::begin(const StepTask& task, StepScheme scheme, Vector& guess) {
  task_ = task;
  scheme_ = scheme;
  const double h = task.length;
  state_->move_ground(task.ground_acceleration);
  // Rates of forces under a weight jump with that of the vertical component.
  if (std::exchange(vertical_rate_, state_->vertical_ground_rate()) != vertical_rate_ && state_->feels_accelerations())
    jerks_at_start_ = jerks_at_end_ = {};
  const MotionState& start = state_->motion();
  const double *u = start.displacement.data(), *v = start.velocity.data(), *a = start.acceleration.data(),
               *jerk = start.jerk.data();
  if (scheme.filters_corrections && !is_known(jerks_at_start_, jerks_at_end_))
    jerks_at_start_ = {start.time, start.jerk};
  if (!scheme.balances_at_end() && is_known(averaged_at_start_, averaged_at_end_)) a = averaged_at_start_.values.data();
  double* __restrict displacement = predicted_displacement_.data();
  double* __restrict velocity = predicted_velocity_.data();
  double* __restrict first = guess.data();
  const double square = (0.5 - scheme.beta) * h * h;
  if (scheme.corrects_velocity) {
    const double correction = h * h / 12.0;
    if (scheme.filters_corrections) {
      find_correction(jerks_at_start_.values, start_correction_);
      for (int i = 0; i < size(); ++i) {
        displacement[i] = u[i] + h * (v[i] + start_correction_[i]) + square * a[i];
        velocity[i] = v[i] + 0.5 * h * a[i];
        first[i] = a[i] + start_correction_[i] / (correction / h);
      }
    } else {
      with_ground_component(state_->model(), task.ground_jerk, [&, count = size()](const auto& ground_jerk) {
        for (int i = 0; i < count; ++i) {
          const double relative_jerk = jerk[i] - ground_jerk(i);
          const double shift = correction * relative_jerk;
          displacement[i] = u[i] + h * (v[i] + shift) + square * a[i];
          velocity[i] = v[i] + 2.0 * shift + (2.0 / 3.0) * h * a[i];
          first[i] = a[i] + h * relative_jerk;
        }
      });
    }
  } else {
    const double half = (1.0 - scheme.gamma) * h;
    for (int i = 0; i < size(); ++i) {
      displacement[i] = u[i] + h * v[i] + square * a[i];
      velocity[i] = v[i] + half * a[i];
      first[i] = a[i];
    }
  }
  if (!scheme.balances_at_end()) average_start(a);
  state_->trial().time = task.end_time;
}

// Whether the state of a step that was completed has been committed, or its start is tried again.
bool StepEquations::is_known(AtInstant& of_start, AtInstant& of_end) const {
  const double now = state_->motion().time;
  if (of_end.time == now) std::swap(of_end, of_start);
  return of_start.time == now;
}

bool StepEquations::has_factors_of_step() const {
  return factorised_ && scheme_.force_share * scheme_.velocity_weight(task_.length) == factorised_velocity_weight_ &&
         scheme_.force_share * scheme_.displacement_weight(task_.length) == factorised_displacement_weight_ &&
         scheme_.mass_share == factorised_mass_share_;
}

void StepEquations::average_start(const double* acceleration) {
  const GroundColumns ground_inertia = state_->ground_inertia();
  const Vector& force = state_->committed_forces();
  of_start_.resize(size());
  state_->model().mass_matrix().multiply(acceleration, of_start_.data());
  for (int i = 0; i < size(); ++i)
    of_start_[i] =
        (1.0 - scheme_.mass_share) * of_start_[i] +
        (1.0 - scheme_.force_share) * (force[i] + ground_inertia.times(task_.ground_acceleration_at_start, i));
}

void StepEquations::complete() {
  // The unknown of an averaged equation is not the acceleration at the end, but one of first order.
  if (!scheme_.balances_at_end()) {
    averaged_at_end_ = {task_.end_time, state_->trial().acceleration};
    state_->balance(task_.ground_acceleration);
  }
  state_->evaluate_rates();
  balanced_scales_.swap(scales_);  // the next residual writes all of scales_
  if (scheme_.filters_corrections) filter_corrections_at_end();
  if (!scheme_.corrects_velocity) return;
  const double h = task_.length, correction = h * h / 12.0, half = scheme_.gamma * h;
  const MotionState& start = state_->motion();
  MotionState& end = state_->trial();
  const double *v = start.velocity.data(), *a = start.acceleration.data(), *jerk = start.jerk.data(),
               *end_acceleration = end.acceleration.data(), *end_jerk = end.jerk.data();
  double* __restrict velocity = end.velocity.data();
  for (int i = 0; i < size(); ++i) {
    const double corrected =
        scheme_.filters_corrections ? end_correction_[i] - start_correction_[i] : correction * (end_jerk[i] - jerk[i]);
    velocity[i] = v[i] + half * (a[i] + end_acceleration[i]) - corrected;
  }
  state_->evaluate_linear_elements();
}

// h^2/12 times relative jerks, filtered.
void StepEquations::find_correction(const Vector& jerks, Vector& correction) {
  const double factor = task_.length * task_.length / 12.0;
  correction.resize(size());
  with_ground_component(state_->model(), task_.ground_jerk, [&](const auto& ground_jerk) {
    for (int i = 0; i < size(); ++i) correction[i] = factor * (jerks[i] - ground_jerk(i));
  });
  filter(correction, 2);
}

void StepEquations::filter(Vector& values, int power) {
  if (!has_factors_of_step() && !factorise()) return;  // the solution of the step will fail too
  for (int count = 0; count < power; ++count) {
    inertia_.resize(size());
    state_->model().mass_matrix().multiply(values.data(), inertia_.data());
    values.swap(inertia_);
    factorisation_.solve(values);
  }
}

// Results have filtered jerks.
void StepEquations::filter_corrections_at_end() {
  const double h = task_.length;
  const MotionState& start = state_->motion();
  MotionState& end = state_->trial();
  jerks_at_end_ = {task_.end_time, end.jerk};
  find_correction(end.jerk, end_correction_);
  filtered_curve_.resize(size());
  with_ground_component(state_->model(), task_.ground_jerk, [&](const auto& ground_jerk) {
    for (int i = 0; i < size(); ++i) {
      const double before = jerks_at_start_.values[i], after = end.jerk[i];
      filtered_curve_[i] =
          scheme_.corrects_velocity
              ? 2.0 * (end.acceleration[i] - start.acceleration[i] + h * ground_jerk(i)) - h * (before + after)
              : h * (after - before);
      end.jerk[i] = ground_jerk(i) + 12.0 / (h * h) * end_correction_[i];
    }
  });
  filter(filtered_curve_, 1);
}

// The trial state with these accelerations at its end.
void StepEquations::move(const Vector& acceleration) {
  const int count = size();
  MotionState& trial = state_->trial();
  const double displacement_weight = scheme_.displacement_weight(task_.length),
               velocity_weight = scheme_.velocity_weight(task_.length);
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
}

bool StepEquations::compute_residual(const Vector& acceleration, Vector& residual) {
  const int count = size();
  move(acceleration);
  state_->evaluate();

  // m/s^2. Where nothing moves yet, all terms of a row vanish together, and no residual is small beside them.
  constexpr double negligible_acceleration = 1e-12;
  const double* a = acceleration.data();
  const MassMatrix& mass_matrix = state_->model().mass_matrix();
  const double* mass = mass_matrix.diagonal().data();
  inertia_.resize(count);
  mass_matrix.multiply(a, inertia_.data());
  const double* force = state_->internal_forces().data();
  const double* balanced_scales = balanced_scales_.data();
  double* __restrict unbalanced = residual.data();
  double* __restrict scales = scales_.data();
  const auto inertia = [values = inertia_.data()](int i) { return values[i]; };
  const auto inner = [&](int i) { return force[i]; };
  with_ground_inertia(*state_, task_.ground_acceleration, [&](const auto& load) {
    resultants_.with([&](const auto& size) {
      for (int i = 0; i < count; ++i) {
        unbalanced[i] = inertia(i) + force[i] + load(i);
        const double lowest = std::max(0.5 * balanced_scales[i], mass[i] * negligible_acceleration);
        scales[i] = std::max(std::max(size(i, inertia), size(i, inner)), std::max(size(i, load), lowest));
      }
    });
  });
  // A floor in plan is one place: forces that cancel in one of its directions leave round-off of those in another.
  for (const PlacedDiaphragm& diaphragm : state_->model().diaphragms()) {
    if (diaphragm.id.x.is_follower()) continue;
    const int first = diaphragm.id.x.index;
    const double largest = std::max(scales[first], scales[first + 2]);
    for (int i = first; i < first + 3; ++i) scales[i] = largest;
  }
  if (!scheme_.balances_at_end()) {
    const double mass_share = scheme_.mass_share, force_share = scheme_.force_share;
    const GroundColumns ground_inertia = state_->ground_inertia();
    for (int i = 0; i < count; ++i)
      unbalanced[i] = mass_share * inertia(i) +
                      force_share * (force[i] + ground_inertia.times(task_.ground_acceleration, i)) + of_start_[i];
  }
  return true;
}

bool StepEquations::compute_jacobian() {
  const bool known = has_factors_of_step() && state_->tangent_version() == factorised_version_;
  if (!known && !factorise()) return false;
  if (state_->feels_accelerations()) find_coupling();
  return true;
}

void StepEquations::find_coupling() {
  constexpr double jamming = 0.1;
  state_->find(coupling_);
  const double determinant = coupling_.prepare(
      size(), [&](Vector& values) { factorisation_.solve(values); }, scheme_.force_share);
  if (determinant <= jamming)
    throw ConvergenceError{
        "The axial forces of the bearings and their friction lock each other at t = " + to_text(task_.end_time) +
            " s: the motion is not unique where friction differs much under a tall building "
            "(Painleve's jamming). Check the friction coefficients, heights and positions of "
            "bearings.",
        task_.start_time, task_.length, determinant, "bearings"};
}

bool StepEquations::factorise() {
  const double velocity_weight = scheme_.force_share * scheme_.velocity_weight(task_.length),
               displacement_weight = scheme_.force_share * scheme_.displacement_weight(task_.length);
  state_->assemble_tangent(scheme_.mass_share, velocity_weight, displacement_weight, tangent_);
  factorised_ = factorisation_.factorise(tangent_);
  factorised_velocity_weight_ = velocity_weight;
  factorised_displacement_weight_ = displacement_weight;
  factorised_mass_share_ = scheme_.mass_share;
  factorised_version_ = state_->tangent_version();
  return factorised_;
}

double StepEquations::round_off(int row) const {
  // A displacement has a round-off of its last digit. Stiffness times this is a force that no iteration can balance. It
  // matters where net forces are small but displacements are not: at the end of a motion, and beside very stiff links.
  constexpr double last_digits = 8.0 * std::numeric_limits<double>::epsilon();
  const double weight = scheme_.displacement_weight(task_.length);
  const MassMatrix& mass = state_->model().mass_matrix();
  double sum = 0.0;
  // The pattern is symmetric, and so are nearly all tangents: the column is used in place of the row.
  for (SparseMatrix::InnerIterator entry{tangent_, row}; entry; ++entry) {
    const double of_stiffness = entry.value() - mass.at(static_cast<int>(entry.row()), row);
    sum += std::abs(of_stiffness * state_->trial().displacement[entry.row()]);
  }
  return last_digits * sum / weight;
}

}  // namespace moat
