// The one list of integrators.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "analyses/integrators/exact_between_events.hpp"
#include "analyses/integrators/generalized_alpha.hpp"
#include "analyses/integrators/hilber_hughes_taylor.hpp"
#include "analyses/integrators/newmark.hpp"
#include "analyses/integrators/step_scheme.hpp"
#include "analyses/time_history/step_method.hpp"

namespace moat {

/// An integrator is a value with `name`, check() and description(), and with one of two functions: scheme(), the
/// numbers of Newmark's family (analyses/integrators/step_scheme.hpp), or methods(), which makes a StepMethod of its
/// own. Names on the command line, checks and reports follow from this list.
///
///     TransientOptions{.integrator = GeneralizedAlpha{.spectral_radius = 0.8}}
using Integrator = std::variant<Newmark, HilberHughesTaylor, GeneralizedAlpha, ExactBetweenEvents, Automatic>;

/// The integrator of this name, with its default parameters. Throws InputError that starts with `what` and lists the
/// names.
Integrator integrator_named(std::string_view name, std::string_view what = "integrator");
/// "newmark, hht-alpha, ..."
std::string integrator_names();

/// Returns the numbers of its steps; none if it is not of Newmark's family, or chooses them step by step.
std::optional<StepScheme> scheme_of(const Integrator& integrator);
/// Returns the name that the option `--integrator` takes.
std::string_view name_of(const Integrator& integrator);
/// Whether it is ExactBetweenEvents.
inline bool is_exact(const Integrator& integrator) { return std::holds_alternative<ExactBetweenEvents>(integrator); }

/// Makes the methods that take its steps. The state must outlive them. Throws InputError for a model that it cannot
/// integrate.
StepMethods methods_of(const Integrator& integrator, AnalysisState& state, const StepSettings& settings);

}  // namespace moat
