#include "launcher/library.hpp"

#include <unistd.h>

#include "launcher/library_changes.hpp"
#include "launcher/lock.hpp"
#include "launcher/phase.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"
#include "launcher/time_of_change.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// The package database changes with every upgrade and removal, which may take away a library.
bool packages_changed(const fs::path& stamp) {
  const fs::path database = "/var/lib/dpkg/status";
  return fs::exists(database) && changed_since_written(database, stamp);
}

// Checked without the lock: a script need not wait for another moat that builds the tests. Ninja is not asked again
// where nothing has changed since it found no work.
bool is_current(const Places& places, const Part& part) {
  const fs::path stamp = places.build / ("no_work_for_" + joined(part.targets, "_"));
  if (!library_may_have_changed(places, stamp)) return true;
  const fs::path new_stamp = stamp.string() + "." + std::to_string(::getpid());
  write_text(new_stamp, "");  // a change while Ninja looks is later than this
  Command ask{MOAT_NINJA, "-C", places.build, "-n"};
  ask.insert(ask.end(), part.targets.begin(), part.targets.end());
  const bool current = output_of(ask).text.find("ninja: no work to do.") != std::string::npos;
  if (current)
    fs::rename(new_stamp, stamp);
  else
    fs::remove(new_stamp);
  return current;
}

// Tests live in the same build folder. Switching them on adds targets and leaves the library's commands as they are:
// run after test and test after run rebuild nothing.
void switch_on(const Places& places, const std::string& option) {
  const std::string cache = text_of(places.build / "CMakeCache.txt");
  if (option.empty() || cache.find("\n" + option + ":BOOL=ON\n") != std::string::npos) return;
  required_phase(places.logs(), "configure", "with CMake",
                 {"cmake", "-S", places.root, "-B", places.build, "--preset", "release", "-D" + option + "=ON"});
}

}  // namespace

void install_packages(const Places& places, const std::vector<std::string>& lists) {
  Command command{places.root / "moat", "--install"};
  command.insert(command.end(), lists.begin(), lists.end());
  if (const int code = run(command); code != 0) throw Stop{code, ""};
}

void unpack_packages(const Places& places, const std::string& list) {
  const Command command{places.root / "moat", "--unpack", places.build / "unpacked", list};
  if (const int code = run(command); code != 0) throw Stop{code, ""};
}

void bring_up_to_date(const Places& places, const Part& part) {
  if (!places.build_is_ours()) return;
  const fs::path stamp = places.build / "packages_are_installed";
  const bool packages_are_there = part.package_lists.empty() && !packages_changed(stamp);
  if (packages_are_there && part.cmake_option.empty() && is_current(places, part)) return;
  const Lock lock{places.work / ".lock"};
  if (!packages_are_there) {
    std::vector<std::string> lists{"run"};
    lists.insert(lists.end(), part.package_lists.begin(), part.package_lists.end());
    install_packages(places, lists);
    write_text(stamp, "");
  }
  switch_on(places, part.cmake_option);
  Command build{MOAT_NINJA, "-C", places.build};
  build.insert(build.end(), part.targets.begin(), part.targets.end());
  required_phase(places.logs(), "build", part.what, build);
}

}  // namespace moat::launcher
