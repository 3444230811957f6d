// Errors of the linker in a script, in the words of the script's writer.
#pragma once

#include <string>

namespace moat::launcher {

/// A sentence on `main` or on functions that are not defined; empty where the linker misses none of the script's.
std::string link_explanation(const std::string& output, const std::string& script);

}  // namespace moat::launcher
