// The methods of an integrator.
#pragma once

#include "analyses/integrators/integrators.hpp"
#include "analyses/time_history/step_method.hpp"

namespace moat {

/// Makes the methods that take its steps. The model must be prepared and outlive them. Throws InputError for a model
/// that it cannot integrate.
StepMethods methods_of(const Integrator& integrator, AnalysisState& state, const StepSettings& settings);

}  // namespace moat
