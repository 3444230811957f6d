// Other programs, and lines of progress for those that take time.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace moat::launcher {

/// A program, looked for in PATH, and its arguments. No shell is involved.
using Command = std::vector<std::string>;

/// Prints "moat: " and a line to standard error.
void say(const std::string& line);

/// Runs a command to its end and returns its exit code: 128 + the signal that ended it, 127 if it cannot be started.
/// With a log it has no input, and all output goes there. Throws Stop where the log cannot be written.
int run(Command command, const std::filesystem::path& log = {});

/// Runs as run() does, but a command that takes longer than 0.3 s is shown as a line of progress, "moat: build     the
/// library ... 12.3 s"; a shorter one passes in silence.
int phase(const std::filesystem::path& log, const std::string& name, const std::string& detail, const Command& command);

/// Runs as phase() does, but throws Stop with the end of the log where the command fails.
void required_phase(const std::filesystem::path& log, const std::string& name, const std::string& detail,
                    const Command& command);

/// A lock against other programs `moat` that run at the same time, held until the last copy goes out of scope, or this
/// process ends or becomes another program. Waits for it, and says so, while another moat holds it. Makes the file and
/// its folder; throws Stop where that is not possible.
std::shared_ptr<void> lock_of(const std::filesystem::path& file);

/// Replaces the launcher by a program, called `name`, which takes memory in large pages where the system offers them: a
/// new small page costs a script more than filling it. A setting of the user stays. Throws Stop where it cannot start.
[[noreturn]] void become(const std::filesystem::path& program, const std::string& name, const Command& arguments);

}  // namespace moat::launcher
