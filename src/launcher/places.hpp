// Where the launcher finds the checkout and keeps its own files.
#pragma once

#include <filesystem>
#include <string>

#include "launcher/text.hpp"

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
  [[nodiscard]] std::filesystem::path log(const std::string& name) const { return work / "logs" / (name + ".log"); }

  /// A text for a checkout, "./moat run examples/...", for this one: in an installed package the command is `moat`, and
  /// the examples get their whole path.
  [[nodiscard]] std::string adapted(const std::string& text) const {
    if (!installed()) return text;
    const std::string command = replaced(replaced(text, "~/moat/moat ", "moat "), "./moat ", "moat ");
    return replaced(command, " examples/", " " + (root / "examples" / "").string());
  }
};

}  // namespace moat::launcher
