// The integrator that Automatic takes for one model.
#pragma once

#include <optional>
#include <string>

#include "analyses/exact_steps.hpp"
#include "analyses/transient_options.hpp"

namespace moat {

/// An integrator that is not Automatic, and the sentence that says why it was chosen.
struct IntegratorChoice {
  Integrator integrator;  ///< Newmark or ExactBetweenEvents
  std::string reason;     ///< a sentence for reports
};

/// Chooses for Automatic: ExactBetweenEvents, with its steps of at most `longest_step` s in `exact`, or Newmark. The
/// model must be prepared.
IntegratorChoice choose_integrator(Model& model, const TransientOptions& options, double longest_step,
                                   std::optional<ExactSteps>& exact);

}  // namespace moat
