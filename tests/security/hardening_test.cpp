// The built programs: addresses that are bound and read-only before main(), anywhere in memory, and checked buffers.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "run_program.hpp"

namespace moat {
namespace {

class Hardening : public testing::InTemporaryFolder {
 protected:
  void SetUp() override {
    if (testing::run_program("/usr/bin/env", {"readelf", "--version"}, folder).exit_code != 0)
      GTEST_SKIP() << "readelf is not installed (package binutils)";
  }
  [[nodiscard]] std::string readelf(const std::string& option, const std::string& file) const {
    return testing::run_program("/usr/bin/env", {"readelf", option, "--wide", file}, folder).output;
  }
};

TEST_F(Hardening, BindsAddressesBeforeMain) {
  for (const std::string file : {LIBRARY, LAUNCHER, REPORT_COMMAND}) {
    const std::string dynamic = readelf("--dynamic", file);
    EXPECT_TRUE(dynamic.find("BIND_NOW") != std::string::npos || dynamic.find("NOW") != std::string::npos) << file;
    EXPECT_NE(readelf("--program-headers", file).find("GNU_RELRO"), std::string::npos) << file;
    EXPECT_NE(readelf("--file-header", file).find("DYN ("), std::string::npos) << file << " has a fixed address";
  }
}

TEST_F(Hardening, GuardsBuffersOfPrograms) {
  EXPECT_NE(readelf("--symbols", LAUNCHER).find("__stack_chk_fail"), std::string::npos);
}

}  // namespace
}  // namespace moat
