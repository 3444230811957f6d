// Where the launcher finds the checkout and keeps its own files.
#pragma once

#include <filesystem>

namespace moat::launcher {

/// The folders that the bootstrap script `moat` hands over.
struct Places {
  /// The checkout: sources, examples, package lists. In an installed package only headers and examples.
  std::filesystem::path root;
  /// CMake's folder with the library. Not ours to write where it belongs to another user.
  std::filesystem::path build;
  /// Compiled scripts, logs and locks. Always ours: <root>/build, or a folder in the user's cache.
  std::filesystem::path work;

  [[nodiscard]] bool installed() const { return !exists(root / "CMakeLists.txt"); }
  [[nodiscard]] bool build_is_ours() const { return build.parent_path() == work; }
  [[nodiscard]] std::filesystem::path scripts() const { return work / "scripts"; }
  [[nodiscard]] std::filesystem::path logs() const { return work / "logs"; }
};

}  // namespace moat::launcher
