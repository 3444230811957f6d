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
  const bool automatic = is_automatic(options.integrator);
  if (!automatic && !is_exact(options.integrator)) return {options.integrator, {}};
  if (automatic && options.step.si() > 0.0) return newmark("the step is fixed.");
  if (automatic && model.degrees_of_freedom() > Automatic::most_degrees_of_freedom)
    return newmark("exact steps cost more for a model of more than " +
                   std::to_string(Automatic::most_degrees_of_freedom) + " degrees of freedom; this one has " +
                   std::to_string(model.degrees_of_freedom()) + ".");
  try {
    exact.emplace(model, control);
  } catch (const InputError& error) {
    // The elements were evaluated for the linear system.
    model.return_to_committed_state();
    if (!automatic) throw;
    return newmark("exact steps do not apply. " + std::string{error.what()});
  }
  if (!automatic) return {options.integrator, {}};
  return {ExactBetweenEvents{},
          "Integrator chosen automatically: exact between events, because the model is small and linear between "
          "located events."};
}

}  // namespace moat
