// The interface of methods that compute a trial state from the committed state.
#pragma once

#include "analyses/integrators/step_equations.hpp"
#include "model/model.hpp"

namespace moat {

/// Solves time steps. Implicit steps (analyses/integrators/implicit_steps.hpp) can be used for every model, exact ones
/// (analyses/integrators/exact_steps.hpp) for models that are linear between events. A stepper does not depend on
/// observers, files or the location of events, which may shorten its steps.
class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Length of the step to try next, s.
  [[nodiscard]] virtual double next_length() = 0;
  /// Sets up a step from the committed state.
  virtual void begin(const StepTask& step) = 0;
  /// Solves the step, or its first part, into the trial state, with all forces and their rates. False if it did not
  /// converge.
  virtual bool solve(const StepTask& part) = 0;
  /// Judges the trial state that solve() led to. False: begin again with next_length(), which is shorter.
  [[nodiscard]] virtual bool accepts(const StepTask& step) = 0;
  /// How the work of its steps is formed.
  [[nodiscard]] virtual WorkRule work_rule() const = 0;
};

}  // namespace moat
