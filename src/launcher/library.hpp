// Brings the library up to date.
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// A part of the build that a command needs.
struct Part {
  /// For the line of progress.
  std::string what;
  /// Of the build.
  std::vector<std::string> targets;
  /// Of cmake/packages, besides `run`; installed where they are missing.
  std::vector<std::string> package_lists{};
  /// The option of CMake that adds the targets; empty if they are always there.
  std::string cmake_option{};
};

/// Installs packages, configures and builds, as far as necessary; nothing where the build folder is not ours. Throws
/// Stop where one of them fails.
void bring_up_to_date(const Places& places, const Part& part);

/// Installs the packages of these lists (cmake/packages) that are missing. Throws Stop where that fails.
void install_packages(const Places& places, const std::vector<std::string>& lists);

/// Unpacks the packages of this list, which conflict with installed ones, into <build>/unpacked. Throws Stop where that
/// fails.
void unpack_packages(const Places& places, const std::string& list);

}  // namespace moat::launcher
