// The built programs: addresses that are bound and read-only before main(), anywhere in memory, and checked buffers.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "run_program.hpp"

namespace moat {
namespace {

class Hardening : public testing::InTemporaryFolder {
 protected:
  // The linker's package, binutils, has readelf.
  [[nodiscard]] std::string readelf(const std::string& option, const std::string& file) const {
    const auto run = testing::run_program("/usr/bin/env", {"readelf", option, "--wide", file}, folder);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return run.output;
  }
};

TEST_F(Hardening, BindsAddressesBeforeMain) {
  for (const std::string file : {LIBRARY, LAUNCHER, REPORT_COMMAND}) {
    EXPECT_NE(readelf("--dynamic", file).find("NOW"), std::string::npos) << file;
    EXPECT_NE(readelf("--program-headers", file).find("GNU_RELRO"), std::string::npos) << file;
    EXPECT_NE(readelf("--file-header", file).find("DYN ("), std::string::npos) << file << " has a fixed address";
  }
}

TEST_F(Hardening, GuardsBuffersOfPrograms) {
  EXPECT_NE(readelf("--symbols", LAUNCHER).find("__stack_chk_fail"), std::string::npos);
}

}  // namespace
}  // namespace moat
