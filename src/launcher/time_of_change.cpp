#include "launcher/time_of_change.hpp"

#include <sys/stat.h>

namespace moat::launcher {
namespace {

timespec time_of_change(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? status.st_ctim : timespec{};
}

}  // namespace

bool changed_after(const std::filesystem::path& file, const std::filesystem::path& other) {
  const timespec a = time_of_change(file), b = time_of_change(other);
  return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
}

}  // namespace moat::launcher
