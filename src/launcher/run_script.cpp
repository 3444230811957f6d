#include <unistd.h>

#include <cstdlib>

#include "launcher/commands.hpp"
#include "launcher/library.hpp"
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

}  // namespace

void become_job(const Command& command) {
  // The job is a group of its own, so that Ctrl-C in the terminal reaches the shell alone.
  Command job{"-c", R"(
    set -m
    exec 3>&2 2>/dev/null # the shell has nothing to say
    first=0
    hand_on() { if ((first)); then kill -TERM $!; else first=$1 && kill -USR1 $! || exit $((128 + first)); fi; }
    trap 'hand_on 1' HUP
    trap 'hand_on 2' INT
    trap 'hand_on 15' TERM
    setpriv --pdeathsig TERM "$@" </dev/null 2>&3 3>&- &
    wait $! # until it ends, or a signal comes
    while kill -0 $!; do wait $!; done
    wait $!
    code=$?
    exit $((first && code ? 128 + first : code)))",
              "moat"};
  job.insert(job.end(), command.begin(), command.end());
  become("/bin/bash", "moat", job);
}

void run_script(const Places& places, int ranks, Command words) {
  if (words.empty())
    throw Stop{exit_usage, "run needs an input script.\nFor example: ./moat run examples/01_moat_wall.cpp"};
  const std::string typed = words.front();
  words.erase(words.begin());
  check_name(typed);
  Part part{.what = "the library", .targets = {"moat_for_scripts"}};
  if (ranks > 0) {
    part.package_lists = {"mpi"};
    part.cmake_option = "MOAT_MPI";
  }
  bring_up_to_date(places, part);
  const fs::path program = program_of_script(places, typed);
  // For the results, which name the script and its hash, and for the command that goes on with a study.
  ::setenv("MOAT_SCRIPT", fs::absolute(typed).lexically_normal().c_str(), 1);
  ::setenv("MOAT_LAUNCHER", (places.root / "moat").c_str(), 1);
  // The script is called by its own name, so that its messages and its results are.
  if (ranks == 0) become(program, typed, words);
  // In a job of Slurm its nodes are used.
  Command job{"mpirun", "-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
  for (const char* variable : {"MOAT_SCRIPT", "MOAT_LAUNCHER", "GLIBC_TUNABLES"})
    job.insert(job.end(), {"-x", variable});
  if (::geteuid() == 0) job.emplace_back("--allow-run-as-root");
  job.push_back(program);
  job.insert(job.end(), words.begin(), words.end());
  become_job(job);
}

}  // namespace moat::launcher
