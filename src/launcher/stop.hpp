// The end of a command before its time.
#pragma once

#include <stdexcept>
#include <string>

namespace moat::launcher {

inline constexpr int exit_failed = 1, exit_usage = 2;

/// Ends the launcher with a message (one or more lines, each printed with "moat: " before it) and an exit code.
struct Stop : std::runtime_error {
  Stop(int code, const std::string& message) : std::runtime_error{message}, exit_code{code} {}
  int exit_code;
};

}  // namespace moat::launcher
