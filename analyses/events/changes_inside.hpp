// Changes of regime that a step crosses without ending there.
#pragma once

#include <vector>

#include "analyses/time_history/step_solver.hpp"

namespace moat {

/// Treats changes of regime inside the step (EventTreatment::inside_the_step): their instants and approach speeds come
/// from the interpolated motion, and the step is solved with the regimes that follow and with the whole impulses of
/// their forces.
class ChangesInside {
 public:
  /// Degrees of freedom up to which EventTreatment::automatic ends steps at changes: that costs little there.
  static constexpr int located_up_to = 1000;

  /// The step must outlive this object.
  ChangesInside(StepSolver& step, EventTreatment treatment) : step_{&step}, treatment_{treatment} {}

  /// Whether a step with this number of crossings keeps its end instead of ending at the first change: by
  /// EventTreatment::inside_the_step, or where changes are many.
  [[nodiscard]] bool wanted(int crossings) const;

  /// Enters the regimes that follow from the predicted motion of the whole step and lists them in `changes`, so that
  /// the first solution has them. settle() locates them again.
  void foresee(std::vector<RegimeChange>& changes);
  /// Solves the trial step of length h again with the regimes that elements enter inside it, at instants located on
  /// its solution, until no other change is seen. False if a change cannot be crossed: the regimes are as before, and
  /// the trial state must be solved again.
  bool settle(double h, std::vector<RegimeChange>& changes);
  /// A step with this number of changes, inside it or at its end, was accepted.
  void accepted(std::size_t changes);

 private:
  bool enter(double h, std::vector<RegimeChange>& changes);
  void take_back(std::vector<RegimeChange>& changes);

  StepSolver* step_;
  EventTreatment treatment_;
  double changes_per_step_ = 0.0;  // over the last steps, at most one of each
};

}  // namespace moat
