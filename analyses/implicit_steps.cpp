#include "analyses/implicit_steps.hpp"

#include <utility>

namespace moat {

ImplicitSteps::ImplicitSteps(Model& model, const TransientOptions& options, const StepControl::Options& control)
    : model_{&model},
      equations_{model},
      newton_{equations_, {.tolerance = options.force_tolerance, .max_iterations = options.max_iterations}},
      control_{model, control} {
  acceleration_.setZero(model.degrees_of_freedom());
}

double ImplicitSteps::next_length() {
  const StepControl::Step step = control_.next_step(*model_);
  scheme_ = step.scheme;
  return step.length;
}

void ImplicitSteps::predict(const StepTask& step) {
  equations_.predict(step, scheme_, acceleration_);
  is_set_up_ = true;
}

bool ImplicitSteps::solve(const StepTask& part) {
  if (!std::exchange(is_set_up_, false)) equations_.begin(part, scheme_, acceleration_);
  // The first Newton step may have been taken already.
  const int taken = equations_.has_extrapolated() ? 1 : 0;
  last_report_ = newton_.solve(acceleration_, 1 - taken);
  newton_iterations_ += last_report_.iterations + taken;
  if (last_report_.converged) equations_.complete();
  return last_report_.converged;
}

}  // namespace moat
