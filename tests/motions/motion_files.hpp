// Text files that a test writes for the readers of ground motions, and the messages it gets back.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "message_of.hpp"

namespace moat {

/// A folder of its own for every test, removed at its end.
class MotionFiles : public ::testing::Test {
 protected:
  MotionFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "moat_motions_XXXXXX").string();
    const char* made = mkdtemp(pattern.data());
    EXPECT_NE(made, nullptr);
    folder_ = pattern;
  }
  ~MotionFiles() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

using testing::message_of;

}  // namespace moat
