// Brings the library up to date.
#pragma once

#include <string>

#include "launcher/places.hpp"
#include "launcher/process.hpp"

namespace moat::launcher {

/// A part of the build that a command needs.
struct Part {
  /// For the line of progress.
  std::string what;
  /// Targets of the build.
  std::vector<std::string> targets;
  /// Lists of cmake/packages, besides `run`; their packages are installed where they are missing.
  std::vector<std::string> package_lists{};
  /// The option of CMake that adds the targets; empty if they are always there.
  std::string cmake_option{};
};

/// Installs packages, configures and builds, as far as necessary; nothing where the build folder is not ours. Throws
/// Stop where one of them fails.
void bring_up_to_date(const Places& places, const Part& part);

/// Calls the bootstrap script, which answers some commands itself. Throws Stop with its exit code where it fails.
void call_bootstrap(const Places& places, Command words, const Command& more);

/// Whether a source of the library, the commit, a list of the build, or a file of the built library changed since
/// `stamp` was written, or there is no stamp. It looks at dates alone: a script that starts need not wait until Ninja
/// has read the lists of the whole build.
bool library_may_have_changed(const Places& places, const std::filesystem::path& stamp);

}  // namespace moat::launcher
