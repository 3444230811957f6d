// Tests that did not run, from a report of CTest.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

struct SkippedTest {
  std::string name;
  /// The text of GTEST_SKIP(), or CTest's word for it: "notrun", "disabled".
  std::string reason;
};

/// Reads a JUnit file written by `ctest --output-junit`. A file that does not exist names no test.
std::vector<SkippedTest> skipped_tests(const std::filesystem::path& report);

}  // namespace moat::launcher
