#include "study/file/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"

namespace moat {
namespace {

// Another process may have removed the file between its opening and its locking.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat locked {
  }, there{};
  return ::fstat(descriptor, &locked) == 0 && ::stat(path.c_str(), &there) == 0 && locked.st_ino == there.st_ino &&
         locked.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : path_{file} {
  path_ += ".lock";
  while (true) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw FileError{"study " + file.string() + ": " + path_.string() +
                      " cannot be made. Give a file in a folder that exists and can be written."};
    const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (locked && is_file_at(descriptor_, path_)) return;
    ::close(descriptor_);
    if (!locked)
      throw InputError{"study " + file.string() +
                       ": another process computes it now. Wait for its end, or give another file."};
  }
}

FileLock::~FileLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace moat
