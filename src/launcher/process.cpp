#include "launcher/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <future>
#include <iostream>

#include "base/text/terminal.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

extern char** environ;

namespace moat::launcher {
namespace {

std::vector<char*> argument_list(Command& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

void say(const std::string& line) { print_text(std::cerr, "moat: " + line + "\n"); }

int run(Command command, const std::filesystem::path& log) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (!log.empty()) {
    std::filesystem::create_directories(log.parent_path());
    write_text(log, "");
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  }
  const std::vector<char*> list = argument_list(command);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, list.front(), &files, nullptr, list.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  int status = 0;
  while (started && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!started) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int phase(const std::filesystem::path& log, const std::string& name, const std::string& detail,
          const Command& command) {
  using namespace std::chrono_literals;
  const std::string padding(name.size() < 9 ? 9 - name.size() : 0, ' ');
  const std::string line = "moat: " + name + padding + " " + printable(detail) + " ... ";
  // On a terminal the line is written again and again.
  const std::string again = ::isatty(STDERR_FILENO) != 0 ? "\r" + line : "";
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  auto exit_code = std::async(std::launch::async, [&] { return run(command, log); });
  const bool is_short = exit_code.wait_for(300ms) == std::future_status::ready;
  if (!is_short) std::fputs(line.c_str(), stderr);
  while (exit_code.wait_for(1s) != std::future_status::ready)
    if (!again.empty()) std::fprintf(stderr, "%s%.0f s ", again.c_str(), seconds());
  const int code = exit_code.get();
  if (!is_short || code != 0)
    std::fprintf(stderr, "%s%s%.1f s\n", (is_short ? line : again).c_str(), code == 0 ? "" : "FAILED after ",
                 seconds());
  return code;
}

void required_phase(const std::filesystem::path& log, const std::string& name, const std::string& detail,
                    const Command& command) {
  if (phase(log, name, detail, command) == 0) return;
  constexpr std::size_t most_lines = 25;
  const std::vector<std::string> lines = lines_of(with_short_lines(text_of(log)));
  for (std::size_t i = lines.size() < most_lines ? 0 : lines.size() - most_lines; i < lines.size(); ++i)
    print_text(std::cerr, "    " + lines[i] + "\n");
  throw Stop{exit_failed, "The whole log: " + log.string()};
}

std::shared_ptr<void> lock_of(const std::filesystem::path& file) {
  std::error_code ignored;
  create_directories(file.parent_path(), ignored);
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw Stop{exit_failed, file.string() + " cannot be written."};
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    say("Waiting for another moat that is building ...");
    ::flock(descriptor, LOCK_EX);
  }
  return {nullptr, [descriptor](void*) { ::close(descriptor); }};
}

void become(const std::filesystem::path& program, const std::string& name, const Command& arguments) {
  Command words{name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  // Memory is taken from the system in pieces of 64 MiB, and up to 1 GiB of free memory is kept: pages that are taken
  // again are cleared again. Single pieces from 32 MiB on go back.
  ::setenv("GLIBC_TUNABLES",
           "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864:glibc.malloc.trim_threshold=1073741824:"
           "glibc.malloc.mmap_threshold=33554432",
           0);
  ::execv(program.c_str(), argument_list(words).data());
  throw Stop{exit_failed, program.string() + " cannot be started: " + std::strerror(errno)};
}

}  // namespace moat::launcher
