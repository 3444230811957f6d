#include "launcher/run_script.hpp"

#include <unistd.h>

#include <cstdlib>
#include <cstring>

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
  if (!fs::is_regular_file(typed) || ::access(typed.c_str(), R_OK) != 0)
    throw Stop{exit_usage, "There is no readable script " + typed + " here, in " + fs::current_path().string() +
                               ".\nStart one with: ./moat new " + typed};
  if (!typed.ends_with(".cpp"))
    throw Stop{exit_usage, typed + " is not an input script: its name does not end in .cpp.\nSee ./moat run --help."};
}

}  // namespace

void run_script(const Places& places, const std::vector<std::string>& words) {
  if (words.empty())
    throw Stop{exit_usage, "run needs an input script.\nFor example: ./moat run examples/01_moat_wall.cpp"};
  const std::string& typed = words.front();
  check_name(typed);
  const ScriptBuild script{places, typed};
  bring_up_to_date(places, {.what = "the library", .targets = {"moat_for_scripts"}});
  const Lock lock{script.lock_file()};  // until the program has started
  script.bring_up_to_date();
  // For the results, which name the script and its hash.
  ::setenv("MOAT_SCRIPT", fs::absolute(typed).lexically_normal().c_str(), 1);
  // The script is called by its own name, so that its messages and its results are.
  const std::vector<std::string> options{words.begin() + 1, words.end()};
  if (become(script.program(), typed, options) == ENOEXEC) {  // damaged, by a power cut for example
    script.rebuild();
    become(script.program(), typed, options);
  }
  throw Stop{exit_failed, script.program().string() + " cannot be started: " + std::strerror(errno)};
}

}  // namespace moat::launcher
