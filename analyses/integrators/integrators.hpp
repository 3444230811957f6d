// The one list of integrators.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "analyses/integrators/automatic.hpp"
#include "analyses/integrators/exact_between_events.hpp"
#include "analyses/integrators/generalized_alpha.hpp"
#include "analyses/integrators/hilber_hughes_taylor.hpp"
#include "analyses/integrators/newmark.hpp"

namespace moat {

/// An integrator is a value with `name`, check(), description() and scheme(): the numbers of its steps
/// (analyses/integrators/step_scheme.hpp). Names on the command line, checks and reports follow from this list.
///
///     TransientOptions{.integrator = GeneralizedAlpha{.spectral_radius = 0.8}}
using Integrator = std::variant<Newmark, HilberHughesTaylor, GeneralizedAlpha, ExactBetweenEvents, Automatic>;

/// The integrator of this name, with its default parameters. Throws InputError that starts with `what` and lists the
/// names.
Integrator integrator_named(std::string_view name, std::string_view what = "integrator");
/// "newmark, hht-alpha, ..."
std::string integrator_names();

/// The numbers of its implicit step; empty for exact steps.
std::optional<StepScheme> scheme_of(const Integrator& integrator);
/// That of the option `--integrator`.
std::string_view name_of(const Integrator& integrator);
/// Whether it is ExactBetweenEvents.
inline bool is_exact(const Integrator& integrator) { return std::holds_alternative<ExactBetweenEvents>(integrator); }
/// Whether it is Automatic.
inline bool is_automatic(const Integrator& integrator) { return std::holds_alternative<Automatic>(integrator); }

}  // namespace moat
