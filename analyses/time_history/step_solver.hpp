// One step being tried.
#pragma once

#include "analyses/events/chatter_guard.hpp"
#include "analyses/integrators/implicit_steps.hpp"
#include "analyses/time_history/step_grid.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// The step being tried from the committed state: solves it, or shorter parts of it, and looks for changes of regime
/// in it.
class StepSolver {
 public:
  /// All must outlive this object.
  StepSolver(Model& model, const TransientOptions& options, const StepGrid& grid, ImplicitSteps& implicit,
             SolverStatistics& statistics);

  /// Sets up the next step by this stepper.
  void begin(Stepper& stepper);
  /// The stepper of the last begin().
  [[nodiscard]] Stepper& stepper() const { return *stepper_; }
  /// The whole step, and its first h seconds.
  [[nodiscard]] const StepTask& whole() const { return whole_; }
  /// 0 < h <= the whole step, s. Valid until the next call.
  [[nodiscard]] const StepTask& first_part(double h);

  /// Solves the first h seconds into the trial state. False if that did not converge.
  bool solve(double h);
  /// Solves the first h seconds, cut in half until that converges; returns the length that did. Throws ConvergenceError
  /// that names time, step, residual and the worst node after `max_cuts` cuts.
  double solve_cutting(double h);
  /// Changes of regime in the trial step of length h. The aim is the middle of the band of margins in which a located
  /// step may end, beyond the change and not before it.
  [[nodiscard]] RegimeScan scan(double h) const { return model_->scan_regimes(h, aim()); }
  /// m, < 0.
  [[nodiscard]] double aim() const { return -0.5 * location_tolerance_; }
  /// m, > 0: the band of margins in which a located step ends.
  [[nodiscard]] double location_tolerance() const { return location_tolerance_; }

  /// The model as given.
  [[nodiscard]] Model& model() const { return *model_; }
  /// The implicit steps as given.
  [[nodiscard]] ImplicitSteps& implicit() const { return *implicit_; }
  /// Counts of the steps solved here.
  [[nodiscard]] SolverStatistics& statistics() const { return *statistics_; }

 private:
  [[noreturn]] void give_up(double h) const;

  Model* model_;
  const StepGrid* grid_;
  ImplicitSteps* implicit_;
  SolverStatistics* statistics_;
  double location_tolerance_, force_tolerance_;
  int max_cuts_;
  Stepper* stepper_;
  StepTask whole_, part_;
};

}  // namespace moat
