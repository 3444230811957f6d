#include "launcher/library.hpp"

#include <unistd.h>

#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// Checked without the lock: a script need not wait for another moat that builds the tests. Ninja is not asked again
// where nothing has changed since it found no work.
bool is_current(const Places& places, const Part& part) {
  const fs::path stamp = places.build / ("no_work_for_" + joined(part.targets, "_"));
  if (!library_may_have_changed(places, stamp)) return true;
  const std::string mine = stamp.string() + "." + std::to_string(::getpid()), log = mine + ".log";
  write_text(mine, "");  // a change while Ninja looks is later than this
  Command ask{MOAT_NINJA, "-C", places.build, "-n"};
  ask.insert(ask.end(), part.targets.begin(), part.targets.end());
  run(ask, log);
  const bool current = text_of(log).find("ninja: no work to do.") != std::string::npos;
  fs::remove(log);
  if (current)
    fs::rename(mine, stamp);
  else
    fs::remove(mine);
  return current;
}

// Tests live in the same build folder. Switching them on adds targets and leaves the library's commands as they are:
// run after test and test after run rebuild nothing.
void switch_on(const Places& places, const std::string& option) {
  const std::string cache = text_of(places.build / "CMakeCache.txt");
  if (option.empty() || cache.find("\n" + option + ":BOOL=ON\n") != std::string::npos) return;
  required_phase(places.log("configure"), "configure", "with CMake",
                 {"cmake", "-S", places.root, "-B", places.build, "--preset", "release", "-D" + option + "=ON"});
}

}  // namespace

void call_bootstrap(const Places& places, Command words, const Command& more) {
  words.insert(words.begin(), places.root / "moat");
  words.insert(words.end(), more.begin(), more.end());
  if (const int code = run(words); code != 0) throw Stop{code, ""};
}

bool library_may_have_changed(const Places& places, const fs::path& stamp) {
  Command find{"find"};
  const auto add = [&](const fs::path& place) {
    if (fs::exists(place)) find.push_back(place);
  };
  // In `src` lies the library, in `script_header` the precompiled header of scripts.
  for (const char* name : {"build.ninja", ".ninja_log", "CMakeCache.txt", "src", "script_header"})
    add(places.build / name);
  const char* const names = "CMakeLists.txt CMakePresets.json .git/logs/HEAD cmake " MOAT_LIBRARY_FOLDERS;
  for (const std::string& name : lines_of(replaced(names, " ", "\n"))) add(places.root / name);
  find.insert(find.end(), {"-cnewer", stamp, "-exec", "false", "{}", "+"});  // fails where it finds anything
  return !fs::exists(stamp) || run(find) != 0;
}

void bring_up_to_date(const Places& places, const Part& part) {
  if (!places.build_is_ours()) return;
  // The package database changes with every upgrade and removal, which may take away a library.
  const fs::path stamp = places.build / "packages_are_installed";
  const bool packages_are_there = part.package_lists.empty() && fs::exists(stamp) &&
                                  time_of_change("/var/lib/dpkg/status") <= time_of_change(stamp);
  if (packages_are_there && part.cmake_option.empty() && is_current(places, part)) return;
  const auto lock = lock_of(places.work / ".lock");
  if (!packages_are_there) {
    call_bootstrap(places, {"--install", "run"}, part.package_lists);
    write_text(stamp, "");
  }
  switch_on(places, part.cmake_option);
  Command build{MOAT_NINJA, "-C", places.build, "--quiet"};
  build.insert(build.end(), part.targets.begin(), part.targets.end());
  required_phase(places.log("build"), "build", part.what, build);
}

}  // namespace moat::launcher
