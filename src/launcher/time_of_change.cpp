#include "launcher/time_of_change.hpp"

#include <sys/stat.h>

namespace moat::launcher {
namespace {

struct stat status_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return status;
}

bool is_later(timespec a, timespec b) { return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec; }

}  // namespace

bool changed_after(const std::filesystem::path& file, const std::filesystem::path& other) {
  return is_later(status_of(file).st_ctim, status_of(other).st_ctim);
}

timespec time_of_writing(const std::filesystem::path& file) { return status_of(file).st_mtim; }

bool changed_since(const std::filesystem::path& file, timespec instant) {
  return instant.tv_sec == 0 || !is_later(instant, status_of(file).st_ctim);
}

}  // namespace moat::launcher
