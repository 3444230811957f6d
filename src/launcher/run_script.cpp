#include "launcher/run_script.hpp"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "launcher/job.hpp"
#include "launcher/library.hpp"
#include "launcher/lock.hpp"
#include "launcher/process.hpp"
#include "launcher/script_build.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

void check_name(const std::string& typed) {
  if (typed.starts_with('-'))
    throw Stop{exit_usage, "run has no option " + typed +
                               ".\nOptions of the script come after its name: ./moat run SCRIPT.cpp " + typed};
  std::error_code too_long;
  if (!fs::is_regular_file(typed, too_long) || ::access(typed.c_str(), R_OK) != 0)
    throw Stop{exit_usage, "There is no readable script " + typed + " here, in " + fs::current_path().string() +
                               ".\nStart one with: ./moat new " + typed};
  if (!typed.ends_with(".cpp"))
    throw Stop{exit_usage, typed + " is not an input script: its name does not end in .cpp.\nSee ./moat run --help."};
}

/// The number behind --ranks in front of the script's name; empty without it.
std::string take_ranks(std::vector<std::string>& words) {
  if (words.empty() || words.front() != "--ranks") return "";
  constexpr int most = 4096;  // mpirun takes any number, and starts processes until the memory is full
  const std::string given = words.size() < 2 ? "" : words[1];
  int ranks = 0;
  const auto [end, failure] = std::from_chars(given.data(), given.data() + given.size(), ranks);
  if (failure != std::errc{} || end != given.data() + given.size() || ranks < 1 || ranks > most)
    throw Stop{exit_usage, "--ranks needs a number of processes: --ranks = " + given +
                               " is not allowed; it must be a whole number >= 1 and <= " + std::to_string(most) +
                               ".\nFor example: ./moat run --ranks 4 SCRIPT.cpp"};
  words.erase(words.begin(), words.begin() + 2);
  return std::to_string(ranks);
}

/// The job of Open MPI that runs the program on this number of ranks. In a job of Slurm its nodes are used.
int run_ranks(const std::string& ranks, const fs::path& program, const std::vector<std::string>& options) {
  prefer_large_pages();
  Command job{"mpirun", "-n", ranks, "--oversubscribe", "--bind-to", "none"};
  for (const char* variable : {"MOAT_SCRIPT", "MOAT_LAUNCHER", "GLIBC_TUNABLES"})
    job.insert(job.end(), {"-x", variable});
  if (::geteuid() == 0) job.emplace_back("--allow-run-as-root");
  job.push_back(program);
  job.insert(job.end(), options.begin(), options.end());
  return run_job(job);
}

}  // namespace

int run_script(const Places& places, const std::vector<std::string>& all_words) {
  std::vector<std::string> words = all_words;
  const std::string ranks = take_ranks(words);
  if (words.empty())
    throw Stop{exit_usage, "run needs an input script.\nFor example: ./moat run examples/01_moat_wall.cpp"};
  const std::string& typed = words.front();
  check_name(typed);
  const ScriptBuild script{places, typed};
  Part part{.what = "the library", .targets = {"moat_for_scripts"}};
  if (!ranks.empty()) {
    part.package_lists = {"mpi"};
    part.cmake_option = "MOAT_MPI";
  }
  bring_up_to_date(places, part);
  std::optional<Lock> lock{script.lock_file()};  // until the program has started
  script.bring_up_to_date();
  // For the results, which name the script and its hash.
  ::setenv("MOAT_SCRIPT", fs::absolute(typed).lexically_normal().c_str(), 1);
  // For the command that goes on with a study.
  ::setenv("MOAT_LAUNCHER", (places.root / "moat").c_str(), 1);
  if (!ranks.empty()) {
    lock.reset();
    return run_ranks(ranks, script.program(), {words.begin() + 1, words.end()});
  }
  // The script is called by its own name, so that its messages and its results are.
  become(script.program(), typed, {words.begin() + 1, words.end()});
  throw Stop{exit_failed, script.program().string() + " cannot be started: " + std::strerror(errno)};
}

}  // namespace moat::launcher
