// A lock that keeps a second process away from a study. Included by .cpp files alone.
#pragma once

#include <filesystem>

namespace moat {

/// The file FILE.lock, locked until this object or its process ends, however it ends. Removed at its orderly end.
class FileLock {
 public:
  /// Throws InputError where another process holds the lock, FileError where the file cannot be made.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace moat
