// Steps of Newmark's family, solved by Newton's method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyses/integrators/step_control.hpp"
#include "analyses/integrators/step_equations.hpp"
#include "analyses/integrators/step_scheme.hpp"
#include "analyses/time_history/step_method.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// Steps whose length StepControl chooses, solved by NOX.
class NewmarkMethod final : public StepMethod {
 public:
  /// `scheme`: of every step, with its description; none: StepControl chooses one for each step. The state must
  /// outlive this object.
  NewmarkMethod(AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme = {},
                std::string description = {});

  double propose() override;
  bool solve(const StepTask& task) override;
  bool judge(const StepTask& task) override {
    return control_.accepts(*state_, task, scheme_, equations_.filtered_curve());
  }
  void accepted(const StepTask& task) override { control_.accepted(*state_, task.length, task.ground_acceleration); }
  void restart(bool touched) override;

  WorkRule work_rule() const override { return scheme_.order() > 2 ? WorkRule::quadrature : WorkRule::mean_force; }
  std::string description() const override;
  std::vector<std::string> warnings() const override;
  void add_costs(SolverStatistics& statistics) const override;
  NewtonReport imbalance() const override { return last_report_; }
  void archive(StateArchive& archive) override {
    archive(equations_, newton_, control_, scheme_, acceleration_, last_report_, newton_iterations_);
  }

 private:
  [[nodiscard]] std::vector<std::string> warnings_of_fixed_step() const;

  AnalysisState* state_;
  StepSettings settings_;
  std::optional<StepScheme> scheme_of_all_;
  std::string description_;
  StepEquations equations_;
  NewtonSolver newton_;
  StepControl control_;
  StepScheme scheme_{};  // of the step being tried
  Vector acceleration_;
  NewtonReport last_report_;
  long newton_iterations_ = 0;
};

/// An analysis by this method alone.
StepMethods newmark_alone(AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme = {},
                          std::string description = {});

}  // namespace moat
