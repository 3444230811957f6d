#include "analyses/case/available_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "base/text/number_format.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number behind a key in a file, or the first one; infinite where there is none, and for "max".
double number_in(const fs::path& file, const std::string& key = "") {
  std::ifstream stream{file};
  double number = 0.0;
  for (std::string word; key.empty() || stream >> word;)
    if (key.empty() || word == key) return stream >> number ? number : unlimited;
  return unlimited;
}

/// Bytes left in one group; infinite without a limit.
double left_in(const fs::path& group, const char* limit, const char* use) {
  const double most = number_in(group / limit), used = number_in(group / use);
  const double cached = number_in(group / "memory.stat", "inactive_file");
  return used == unlimited ? unlimited : most - used + (cached == unlimited ? 0.0 : std::min(cached, used));
}

/// The smallest of a group and those above it, as the process sees them.
double left_in_groups(const fs::path& mounted, fs::path group, const char* limit, const char* use) {
  double left = left_in(mounted, limit, use);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path())
    left = std::min(left, left_in(mounted / group, limit, use));
  return left;
}

double left_of_ulimit(const fs::path& proc) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  const double pages = number_in(proc / "self" / "statm");
  return static_cast<double>(limit.rlim_cur) -
         (pages == unlimited ? 0.0 : pages * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

double available_memory(const fs::path& root) {
  const fs::path proc = root / "proc", groups = root / "sys" / "fs" / "cgroup";
  double left = std::min(1024.0 * number_in(proc / "meminfo", "MemAvailable:"), left_of_ulimit(proc));
  std::ifstream list{proc / "self" / "cgroup"};
  for (std::string line; std::getline(list, line);) {
    // "0::/user.slice", "5:memory:/job"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty()) left = std::min(left, left_in_groups(groups, group, "memory.max", "memory.current"));
    if (controllers == "memory")
      left = std::min(left, left_in_groups(groups / "memory", group, "memory.limit_in_bytes", "memory.usage_in_bytes"));
  }
  return std::max(left, 0.0);
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? to_significant(bytes / 1e6, 3) + " MB" : to_significant(bytes / 1e9, 3) + " GB";
}

}  // namespace moat
