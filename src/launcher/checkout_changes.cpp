#include "launcher/checkout_changes.hpp"

#include <algorithm>
#include <sstream>

#include "launcher/text.hpp"
#include "launcher/time_of_change.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// A new file changes its folder.
bool changed(const fs::path& path, const fs::path& stamp) {
  if (changed_since_written(path, stamp)) return true;
  return fs::is_directory(path) && std::ranges::any_of(fs::directory_iterator{path}, [&](const auto& entry) {
           return entry.is_directory() ? changed(entry.path(), stamp) : changed_since_written(entry.path(), stamp);
         });
}

}  // namespace

bool library_may_have_changed(const Places& places, const fs::path& stamp) {
  if (!fs::exists(stamp)) return true;
  for (const char* list : {"build.ninja", ".ninja_log", "CMakeCache.txt"})
    if (changed_since_written(places.build / list, stamp)) return true;
  for (const char* file : {"CMakeLists.txt", "CMakePresets.json", ".git", ".git/logs/HEAD"})
    if (changed_since_written(places.root / file, stamp)) return true;
  for (const std::string& word : lines_of(text_of(places.build / "script_link.txt")))
    if (word.starts_with('/') && !fs::exists(word)) return true;
  std::istringstream folders{"cmake " MOAT_LIBRARY_FOLDERS};
  for (std::string folder; folders >> folder;)
    if (changed(places.root / folder, stamp)) return true;
  return false;
}

}  // namespace moat::launcher
