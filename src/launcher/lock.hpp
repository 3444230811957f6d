// A lock against other programs `moat` that run at the same time.
#pragma once

#include <filesystem>

namespace moat::launcher {

/// Holds a lock from construction to destruction, or until the program ends or becomes another one. Waits for it, and
/// says so, while another moat holds it.
class Lock {
 public:
  /// Makes the file and its folder. Throws Stop where that is not possible.
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int descriptor_;
};

}  // namespace moat::launcher
