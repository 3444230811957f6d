// Runs a program as a user does, and keeps its output.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "in_folder.hpp"

extern char** environ;

namespace moat::testing {

inline std::string text_of(const std::filesystem::path& path) { return read_file(path); }

struct ProgramResult {
  int exit_code = -1;
  std::string output, errors;   ///< standard output and standard error
  double largest_memory = 0.0;  ///< bytes, not less than those of the test at its start
};

/// A program that runs in `folder` with no terminal.
class RunningProgram {
 public:
  RunningProgram(const std::filesystem::path& program, std::vector<std::string> arguments,
                 const std::filesystem::path& folder)
      : output_{folder / "standard_output"}, errors_{folder / "standard_error"} {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::string name = program.string();
    std::vector<char*> argv{name.data()};
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    started_ = posix_spawn(&child_, program.c_str(), &actions, nullptr, argv.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    EXPECT_TRUE(started_) << "could not start " << program;
  }

  [[nodiscard]] pid_t id() const { return child_; }
  void send(int signal) const {
    if (started_) ::kill(child_, signal);
  }
  /// Its end; the exit code is -1 where a signal ended it.
  ProgramResult wait() const {
    if (!started_) return {};
    int status = 0;
    rusage usage{};
    wait4(child_, &status, 0, &usage);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(output_), text_of(errors_),
            1024.0 * static_cast<double>(usage.ru_maxrss)};
  }

 private:
  std::filesystem::path output_, errors_;
  pid_t child_ = 0;
  bool started_ = false;
};

/// Runs `program` in `folder` to its end.
inline ProgramResult run_program(const std::filesystem::path& program, std::vector<std::string> arguments,
                                 const std::filesystem::path& folder) {
  return RunningProgram{program, std::move(arguments), folder}.wait();
}

using InTemporaryFolder = InFolder;

}  // namespace moat::testing
