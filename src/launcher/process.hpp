// Other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

/// A program, looked for in PATH, and its arguments. No shell is involved.
using Command = std::vector<std::string>;

/// Runs a command to its end and returns its exit code: 128 + the signal that ended it, 127 if it cannot be started.
int run(const Command& command);

/// As run(), with no input, and all output in a file.
int run_into(const std::filesystem::path& log, const Command& command);

struct Output {
  int exit_code = 0;
  std::string text;  ///< of standard output
};
/// As run(), with no input, keeps standard output and drops standard error.
Output output_of(const Command& command);

/// From now on programs take memory in large pages where the system offers them: a new small page costs a script more
/// than filling it. A setting of the user stays.
void prefer_large_pages();

/// Replaces the launcher by a program, with large pages, called `name`. Returns errno where that fails.
int become(const std::filesystem::path& program, const std::string& name, const std::vector<std::string>& arguments);

}  // namespace moat::launcher
