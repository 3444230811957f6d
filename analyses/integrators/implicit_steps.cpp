#include "analyses/integrators/implicit_steps.hpp"

namespace moat {

ImplicitSteps::ImplicitSteps(Model& model, const TransientOptions& options, const StepControl::Options& control)
    : model_{&model},
      equations_{model},
      newton_{equations_,
              {.tolerance = options.force_tolerance,
               .max_iterations = options.max_iterations,
               .line_search = options.line_search}},
      control_{model, control} {
  acceleration_.setZero(model.degrees_of_freedom());
}

double ImplicitSteps::next_length() {
  const StepControl::Step step = control_.next_step(*model_);
  scheme_ = step.scheme;
  return step.length;
}

bool ImplicitSteps::solve(const StepTask& part) {
  equations_.begin(part, scheme_, acceleration_);
  last_report_ = newton_.solve(acceleration_);
  newton_iterations_ += last_report_.iterations;
  if (last_report_.converged) equations_.complete();
  return last_report_.converged;
}

}  // namespace moat
