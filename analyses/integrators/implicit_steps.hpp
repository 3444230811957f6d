// Steps of Newmark's family, solved by Newton's method.
#pragma once

#include "analyses/time_history/step_control.hpp"
#include "analyses/time_history/stepper.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// Steps whose scheme and length StepControl chooses, solved by NOX.
class ImplicitSteps final : public Stepper {
 public:
  /// The model must outlive this object and is prepared here.
  ImplicitSteps(Model& model, const TransientOptions& options, const StepControl::Options& control);

  double next_length() override;
  void begin(const StepTask&) override {}
  bool solve(const StepTask& part) override;
  bool accepts(const StepTask& step) override {
    return control_.accepts(*model_, step, scheme_, equations_.filtered_curve());
  }
  WorkRule work_rule() const override { return scheme_.order() > 2 ? WorkRule::quadrature : WorkRule::mean_force; }

  /// Computes accelerations and jerks of the committed state again, from its forces.
  void balance_committed_state(PlanVector ground_acceleration) {
    equations_.balance_committed_state(ground_acceleration);
  }

  /// Chooses and judges the lengths of steps.
  [[nodiscard]] StepControl& control() { return control_; }
  /// Chooses and judges the lengths of steps.
  [[nodiscard]] const StepControl& control() const { return control_; }
  /// Returns the report of the last solve().
  [[nodiscard]] const NewtonReport& last_report() const { return last_report_; }
  /// Returns the number of iterations of all steps so far.
  [[nodiscard]] long newton_iterations() const { return newton_iterations_; }
  /// Returns the number of factorisations of the tangent so far.
  [[nodiscard]] long factorisations() const { return equations_.factorisations(); }

 private:
  Model* model_;
  StepEquations equations_;
  NewtonSolver newton_;
  StepControl control_;
  StepScheme scheme_{};  // of the step being tried
  Vector acceleration_;
  NewtonReport last_report_;
  long newton_iterations_ = 0;
};

}  // namespace moat
