// The integrator of an analysis.
#pragma once

#include <optional>
#include <string>

#include "analyses/integrators/exact_steps.hpp"
#include "analyses/time_history/transient_options.hpp"

namespace moat {

/// An integrator that is not Automatic, and the sentence that says why it was chosen.
struct IntegratorChoice {
  Integrator integrator;  ///< that of the options; Newmark or ExactBetweenEvents for Automatic
  std::string reason;     ///< a sentence for reports; empty if the options give the integrator
};

/// The integrator of the options, or the one that Automatic takes for this model, which must be prepared. For
/// ExactBetweenEvents, its steps are made in `exact`, which keeps `control`. Throws InputError where the
/// options ask for exact steps and the model is not linear between events.
IntegratorChoice choose_integrator(Model& model, const TransientOptions& options, StepControl& control,
                                   std::optional<ExactSteps>& exact);

}  // namespace moat
