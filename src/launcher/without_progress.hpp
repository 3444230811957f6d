// The logs of builds, tests and clang-tidy, without the steps that went well.
#pragma once

#include <string>

namespace moat::launcher {

/// The errors and warnings of a log, each with its context. Progress of Ninja, CTest, CMake and run-clang-tidy is left
/// out where nothing follows it, and so is the command of a step that failed. A log that holds nothing else is returned
/// as it is. Long lines lack their middle (with_short_lines).
std::string without_progress(const std::string& log);

}  // namespace moat::launcher
