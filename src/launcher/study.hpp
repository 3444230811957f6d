// moat study
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Brings the program that reads studies up to date and becomes it. Throws Stop for wrong usage and where it does not
/// build.
[[noreturn]] void read_study(const Places& places, const std::vector<std::string>& words);

}  // namespace moat::launcher
