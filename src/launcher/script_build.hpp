// Compiles an input script.
#pragma once

#include <filesystem>

#include "launcher/places.hpp"

namespace moat::launcher {

/// The program of a script, in <work>/scripts/<name>-<hash of its path>. It is compiled if the script, a file it
/// includes, the library's headers or the compiler's words have changed, or the program is damaged. Other launchers do
/// not touch it until this process ends or becomes another program.
///
/// `typed` is the script's name as the user gave it. Warnings and errors go to standard error, explained by
/// compile_errors.hpp. Throws Stop if the script does not compile.
std::filesystem::path program_of_script(const Places& places, const std::filesystem::path& typed);

}  // namespace moat::launcher
