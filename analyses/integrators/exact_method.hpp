// Exact steps of a model that is linear between events.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "analyses/integrators/linear_path.hpp"
#include "analyses/integrators/linear_system.hpp"
#include "analyses/time_history/step_method.hpp"
#include "base/vector.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// Steps of a model that is linear between touches, yields and unloadings, by its exact motion
/// (analyses/integrators/linear_path.hpp). The only error is that of the cubic by which elements, changes of regime and
/// peaks are looked at from end to end of a step. A step is so short beside the fastest vibration that this cubic meets
/// it, and within one interval of the motion's samples. It does not apply while a gap is closed.
class ExactMethod final : public StepMethod {
 public:
  /// Matrices are full: this is for small models.
  static constexpr int most_degrees_of_freedom = 50;
  /// Tolerances by which the cubic of a step may miss a vibration. Trial: 64 changes nothing in 200 random models at
  /// the default tolerance, where LinearSystem::longest_phase is the limit; at 1e-6 ExactSteps tests guard it.
  static constexpr double cubics_within = 16.0;

  /// The state must outlive this object. Steps are at most `longest_step` s. Throws InputError for a
  /// model with too many degrees of freedom, an element that is not linear between events, or an eigenvalue that needs
  /// thousands of steps from sample to sample.
  ExactMethod(AnalysisState& state, double longest_step, double tolerance);

  bool applies() const override { return !std::isfinite(state_->shortest_contact()); }
  double propose() override;
  bool solve(const StepTask& task) override;
  void restart(bool) override { system_ = nullptr; }
  WorkRule work_rule() const override { return WorkRule::quadrature; }
  void archive(StateArchive& archive) override;
  std::string description() const override { return "Exact steps while no gap is closed; in contact: "; }

 private:
  void linearise();
  void choose_system();

  AnalysisState* state_;
  double longest_step_, tolerance_;  // s, 1
  std::vector<LinearSystem> systems_;
  const LinearSystem* system_ = nullptr;  // of the current regimes; null: not known yet
  SparseMatrix stiffness_, damping_;
  Vector forces_at_rest_, offset_;  // f0, -M^-1 f0
  LinearPath path_;
  bool begins_ = false;  // the next solve() is that of a whole step
};

}  // namespace moat
