// The equations of one time step.
#pragma once

#include <limits>

#include "analyses/integrators/acceleration_scales.hpp"
#include "analyses/integrators/step_scheme.hpp"
#include "analyses/time_history/step_method.hpp"
#include "model/analysis_state.hpp"
#include "solvers/factorisation.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// M a + f(u(a), v(a)) = -M (iota_x a_gx + iota_y a_gy) at the end of a step, or averaged over it (StepScheme); the
/// unknown is the acceleration a at the end.
///
/// The unknown is not the displacement, because a = (u - prediction) / (beta h^2) loses all digits after a very short
/// step, and steps that end at a located event can be very short.
class StepEquations final : public NonlinearSystem {
 public:
  /// The state must outlive the equations.
  explicit StepEquations(AnalysisState& state);

  /// Sets up a step from the model's committed state. `guess` := accelerations to start from: those at its start, or
  /// where the scheme knows jerks their tangent there.
  void begin(const StepTask& task, StepScheme scheme, Vector& guess);
  /// After the last compute_residual(): jerks of the trial state, and its velocities where the scheme corrects them.
  void complete();

  /// Accelerations of the committed state may have jumped: the next step follows no other.
  void forget() { averaged_at_start_ = averaged_at_end_ = jerks_at_start_ = jerks_at_end_ = {}; }

  int size() const override { return state_->model().degrees_of_freedom(); }
  bool compute_residual(const Vector& acceleration, Vector& residual) override;
  const Vector& residual_scales() const override { return scales_; }
  double round_off(int row) const override;
  bool compute_jacobian() override;
  void solve(Vector& vector) const override {
    factorisation_.solve(vector);
    if (state_->feels_accelerations()) coupling_.correct(vector);
  }

  /// Where the scheme filters corrections: 2 (a1 - a0) - h (j0 + j1) of the last step completed, in absolute motion,
  /// m/s^2, without the round-off of jerks of motions that strong dashpots hold; h (j1 - j0) where it does not correct
  /// velocities. Else null.
  [[nodiscard]] const double* filtered_curve() const {
    return scheme_.filters_corrections ? filtered_curve_.data() : nullptr;
  }

  /// Writes or reads all that one step leaves for the next.
  void archive(StateArchive& archive) {
    archive(scheme_, tangent_, vertical_rate_, scales_, balanced_scales_, factorised_, factorised_velocity_weight_,
            factorised_displacement_weight_, factorised_mass_share_, factorised_version_);
    for (AtInstant* each : {&jerks_at_start_, &jerks_at_end_, &averaged_at_start_, &averaged_at_end_})
      archive(each->time, each->values);
    factorisation_.archive(archive, tangent_);
  }
  /// How often the tangent has been factorised.
  [[nodiscard]] long factorisations() const { return factorisation_.count(); }

 private:
  // Whether the factors have the weights of this step.
  [[nodiscard]] bool has_factors_of_step() const;
  [[nodiscard]] bool factorise();
  void find_coupling();
  // values := (T^-1 M)^power values, with the factors of this step's weights.
  void filter(Vector& values, int power);
  void find_correction(const Vector& jerks, Vector& correction);
  void filter_corrections_at_end();
  void move(const Vector& acceleration);
  void average_start(const double* acceleration);

  AnalysisState* state_;
  Resultants resultants_;
  StepScheme scheme_;
  Factorisation factorisation_;
  SparseMatrix tangent_;
  WeightCoupling coupling_;     // of axial forces, where the state feels accelerations
  double vertical_rate_ = 0.0;  // of the ground at the last begin(), m/s^3
  StepTask task_;
  Vector predicted_displacement_, predicted_velocity_;
  Vector inertia_;   // of the iterate
  Vector of_start_;  // the share of the start in averaged equations
  // Largest force of every row: of the iterate, and of the last balanced step. All terms of a row may be zero at the
  // same instant; its scale is therefore at least half of the latter.
  Vector scales_, balanced_scales_;
  // The tangent that the current factors belong to.
  bool factorised_ = false;
  double factorised_velocity_weight_ = 0.0, factorised_displacement_weight_ = 0.0, factorised_mass_share_ = 0.0;
  long factorised_version_ = 0;
  // Values that belong to the state at this instant.
  struct AtInstant {
    double time = std::numeric_limits<double>::quiet_NaN();  // s
    Vector values;
  };
  [[nodiscard]] bool is_known(AtInstant& of_start, AtInstant& of_end) const;
  // Jerks as the forces have them, h^2/12 times the filtered relative jerks at both ends, and filtered_curve().
  AtInstant jerks_at_start_, jerks_at_end_;
  Vector start_correction_, end_correction_, filtered_curve_;
  // The accelerations of averaged equations, which the next step needs. Those of the state balance its forces.
  AtInstant averaged_at_start_, averaged_at_end_;
};

}  // namespace moat
