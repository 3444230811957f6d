// moat run
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Brings the library and the script's program up to date, and becomes that program; with --ranks N in front it runs
/// the program on N processes and returns their exit code. The first word is the script, the others are its options.
/// Throws Stop for wrong usage and where something does not build.
int run_script(const Places& places, const std::vector<std::string>& words);

}  // namespace moat::launcher
