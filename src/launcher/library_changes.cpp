#include "launcher/library_changes.hpp"

#include <algorithm>
#include <sstream>

#include "launcher/time_of_change.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// A folder changes with every file that is made, renamed or removed in it.
bool tree_changed(const fs::path& folder, timespec instant) {
  return changed_since(folder, instant) ||
         std::ranges::any_of(fs::directory_iterator{folder}, [&](const fs::directory_entry& entry) {
           return entry.is_directory() ? tree_changed(entry, instant) : changed_since(entry, instant);
         });
}

}  // namespace

bool library_may_have_changed(const Places& places, const fs::path& stamp) {
  const timespec written = time_of_writing(stamp);
  // In `src` lies the library, in `script_header` the precompiled header of scripts.
  for (const char* name : {"build.ninja", ".ninja_log", "CMakeCache.txt", "src", "script_header"})
    if (changed_since(places.build / name, written)) return true;
  for (const char* name : {"CMakeLists.txt", "CMakePresets.json", ".git", ".git/logs/HEAD"})
    if (changed_since(places.root / name, written)) return true;
  std::istringstream folders{"cmake " MOAT_LIBRARY_FOLDERS};
  for (std::string folder; folders >> folder;)
    if (tree_changed(places.root / folder, written)) return true;
  return false;
}

}  // namespace moat::launcher
