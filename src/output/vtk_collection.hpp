// The list of the frames of an animation.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace moat {

/// A .pvd file for ParaView. It is complete after every entry.
class VtkCollection {
 public:
  /// Creates or replaces the file, without entries. Throws FileError.
  explicit VtkCollection(const std::filesystem::path& path);
  ~VtkCollection();
  VtkCollection(const VtkCollection&) = delete;
  VtkCollection& operator=(const VtkCollection&) = delete;

  /// `file_name` is relative to the folder of the list. Throws FileError.
  void append(double time, std::string_view file_name);

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::size_t end_ = 0;  // of the entries, bytes
};

}  // namespace moat
