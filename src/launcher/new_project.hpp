// moat new --project
#pragma once

#include <filesystem>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Writes a folder with a project for CMake: CMakeLists.txt, which uses the package moat, a script to start from, and
/// README.md; from examples/project and examples/starter.cpp, with the name of the folder in them. Throws Stop for a
/// name that is no name of a target (letters, digits, - and _), for a folder that exists, and for one whose parent does
/// not.
void new_project(const Places& places, const std::filesystem::path& folder);

}  // namespace moat::launcher
