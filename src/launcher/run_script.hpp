// moat run
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Brings the library and the script's program up to date, and becomes that program. The first word is the script, the
/// others are its options. Throws Stop for wrong usage and where something does not build.
[[noreturn]] void run_script(const Places& places, const std::vector<std::string>& words);

}  // namespace moat::launcher
