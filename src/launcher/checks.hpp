// moat check
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// The names of all checks, in the order in which they run.
std::vector<std::string> check_names();

/// Runs the named checks, or all, goes on after a failure, and returns 1 if one failed. Throws Stop for an unknown
/// name.
int run_checks(const Places& places, std::vector<std::string> names);

}  // namespace moat::launcher
