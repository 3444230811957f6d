#include "analyses/integrators/implicit_steps.hpp"

#include <utility>

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

void ImplicitSteps::predict(const StepTask& step) {
  equations_.predict(step, scheme_, acceleration_);
  is_set_up_ = true;
}

void ImplicitSteps::add_missed_impulses(double length) {
  const bool any = scheme_.balances_at_end() && model_->find_missed_impulses(length, scheme_.impulse_rules(), missed_);
  missed_in_ = any ? length : 0.0;
}

bool ImplicitSteps::solve(const StepTask& part) {
  if (!std::exchange(is_set_up_, false)) equations_.begin(part, scheme_, acceleration_);
  if (part.length == missed_in_) equations_.add_impulses(missed_);
  last_report_ = newton_.solve(acceleration_);
  newton_iterations_ += last_report_.iterations;
  if (last_report_.converged) equations_.complete();
  return last_report_.converged;
}

}  // namespace moat
