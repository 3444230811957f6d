// moat new
#pragma once

#include <filesystem>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Writes a script to start from, examples/starter.cpp with the new name in it. Throws Stop for a name that does not
/// end in .cpp or begins with -, for a file that exists, and for a folder that does not.
void new_script(const Places& places, const std::filesystem::path& typed);

}  // namespace moat::launcher
