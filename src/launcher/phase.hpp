// Commands that take time, as lines of progress.
#pragma once

#include <filesystem>
#include <string>

#include "launcher/process.hpp"

namespace moat::launcher {

/// Prints "moat: " and a line to standard error.
void say(const std::string& line);

/// Runs a command with its output in <logs>/<name>.log, and returns its exit code. A command that takes longer than
/// 0.3 s is shown as a line of progress, "moat: build     the library ... 12.3 s"; a shorter one passes in silence.
int phase(const std::filesystem::path& logs, const std::string& name, const std::string& detail,
          const Command& command);

/// As phase(), but throws Stop with the end of the log where the command fails.
void required_phase(const std::filesystem::path& logs, const std::string& name, const std::string& detail,
                    const Command& command);

}  // namespace moat::launcher
