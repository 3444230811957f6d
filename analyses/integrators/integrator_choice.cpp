#include "analyses/integrators/integrator_choice.hpp"

#include "base/error.hpp"

namespace moat {
namespace {

IntegratorChoice newmark(const std::string& reason) {
  return {Newmark{}, "Integrator chosen automatically: Newmark's method, because " + reason};
}

}  // namespace

IntegratorChoice choose_integrator(Model& model, const TransientOptions& options, StepControl& control,
                                   std::optional<ExactSteps>& exact) {
  if (is_exact(options.integrator)) exact.emplace(model, control);
  if (!is_automatic(options.integrator)) return {options.integrator, {}};
  if (options.step.si() > 0.0) return newmark("the step is fixed.");
  if (model.degrees_of_freedom() > Automatic::most_degrees_of_freedom)
    return newmark("exact steps cost more for a model of more than " +
                   std::to_string(Automatic::most_degrees_of_freedom) + " degrees of freedom; this one has " +
                   std::to_string(model.degrees_of_freedom()) + ".");
  try {
    exact.emplace(model, control);
  } catch (const InputError& error) {
    return newmark("exact steps do not apply. " + std::string{error.what()});
  }
  return {ExactBetweenEvents{},
          "Integrator chosen automatically: exact between events, because the model is small and linear between "
          "located events."};
}

}  // namespace moat
