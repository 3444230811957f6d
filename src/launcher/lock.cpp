#include "launcher/lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "launcher/phase.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

Lock::Lock(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw Stop{exit_failed, file.string() + " cannot be written."};
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  say("Waiting for another moat that is building ...");
  ::flock(descriptor_, LOCK_EX);
}

Lock::~Lock() { ::close(descriptor_); }

}  // namespace moat::launcher
