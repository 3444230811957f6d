// One step being tried.
#pragma once

#include "analyses/time_history/step_grid.hpp"
#include "analyses/time_history/step_method.hpp"
#include "model/analysis_state.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// The step being tried from the committed state: solves it by a method, or shorter parts of it, and looks for changes
/// of regime in it.
class StepSolver {
 public:
  /// All must outlive this object.
  StepSolver(AnalysisState& state, const StepSettings& settings, const StepGrid& grid, SolverStatistics& statistics);

  /// Solves the next step by this method: one of the length that it proposes, or a shorter one where that does not
  /// converge or the method judges its error too large. Returns the length of the trial step, s.
  double solve_next(StepMethod& method);
  /// The last step that was proposed, and its first h seconds.
  [[nodiscard]] const StepTask& whole() const { return whole_; }
  /// 0 < h <= the whole step, s. Valid until the next call.
  [[nodiscard]] const StepTask& first_part(double h);

  /// Solves the first h seconds into the trial state. False if that did not converge.
  bool solve(double h) { return method_->solve(first_part(h)); }
  /// Solves the first h seconds, cut in half until that converges; returns the length that did. Throws ConvergenceError
  /// that names time, step, residual and the worst node after `max_cuts` cuts.
  double solve_cutting(double h);
  /// Changes of regime in the trial step of length h. The aim is the middle of the band of margins in which a located
  /// step may end, beyond the change and not before it.
  [[nodiscard]] RegimeScan scan(double h) const { return state_->scan_regimes(h, aim()); }
  /// m, < 0.
  [[nodiscard]] double aim() const { return -0.5 * location_tolerance_; }
  /// m, > 0: the band of margins in which a located step ends.
  [[nodiscard]] double location_tolerance() const { return location_tolerance_; }

  /// Returns the state that was given.
  [[nodiscard]] AnalysisState& state() const { return *state_; }
  /// Counts of the steps solved here.
  [[nodiscard]] SolverStatistics& statistics() const { return *statistics_; }

 private:
  [[noreturn]] void give_up(double h) const;

  AnalysisState* state_;
  const StepGrid* grid_;
  SolverStatistics* statistics_;
  double location_tolerance_, force_tolerance_;
  int max_cuts_;
  StepMethod* method_ = nullptr;
  StepTask whole_, part_;
};

}  // namespace moat
