// Commands that need the library: each is a program of its own beside the launcher.
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Brings the program of a command, bin/moat_<command>, up to date and becomes it. Throws Stop where it does not build
/// or start.
[[noreturn]] void become_library_program(const Places& places, const std::string& command,
                                         const std::vector<std::string>& words);

}  // namespace moat::launcher
