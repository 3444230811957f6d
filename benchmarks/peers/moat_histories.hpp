// The histories of moat.
#pragma once

#include <string>

#include "analyses/integrators/integrators.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "peers/building.hpp"
#include "peers/ladders.hpp"

namespace moat::peers {

/// A history of the case, with peaks over continuous time.
History moat_history(const Case& of, TransientOptions options);

/// Tolerances, and with them in step the steps per contact, from loose to tight. The case must outlive the ladder.
Ladder moat_ladder(const Case& of, const std::string& name, Integrator integrator);

/// The exact values of the case, or those of a history with a tight tolerance.
performance::Peaks reference_of(const Case& of);

}  // namespace moat::peers
