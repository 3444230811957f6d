// moat test
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

struct TestOptions {
  /// Nothing may be skipped: more packages are installed, and a skipped test is a failure.
  bool all = false;
  /// For CTest.
  std::vector<std::string> words{};
};

/// Builds and runs the tests, lists those that were skipped, and returns the exit code. Throws Stop for wrong usage and
/// where something does not build.
int run_tests(const Places& places, const TestOptions& options);

}  // namespace moat::launcher
