// ./moat bench experiments as it is run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "run_program.hpp"

namespace moat::experiments {
namespace {

class Experiments : public testing::InTemporaryFolder {
 protected:
  void SetUp() override {
    if (const char* before = std::getenv("MOAT_EXPERIMENTS")) before_ = before;
  }
  ~Experiments() override {
    if (!before_.empty()) setenv("MOAT_EXPERIMENTS", before_.c_str(), 1);
  }

 private:
  std::string before_;
};

TEST_F(Experiments, SayWhatIsSkippedWithoutTheirFolders) {
  for (const bool is_set : {false, true}) {
    if (is_set)
      setenv("MOAT_EXPERIMENTS", folder.c_str(), 1);
    else
      unsetenv("MOAT_EXPERIMENTS");
    const testing::ProgramResult run = testing::run_program(MOAT_EXPERIMENTS_PROGRAM, {}, folder);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    for (const auto& [part, data] : {std::pair{"buffalo", "buffalo"},
                                     {"kharaz", "kharaz"},
                                     {"yielding building", "smart_base_isolated"},
                                     {"benchmark building", "smart_base_isolated"}}) {
      const std::string reason =
          is_set ? (folder / data).string() + " is not a folder." : "MOAT_EXPERIMENTS is not set.";
      EXPECT_NE(run.output.find(std::string{part} + ": skipped. " + reason), std::string::npos) << run.output;
    }
  }
}

TEST_F(Experiments, WriteNoDocumentsWithoutOpenSees) {
  const testing::ProgramResult run = testing::run_program(
      "/usr/bin/env", {"-u", "OPENSEES", "-u", "MOAT_EXPERIMENTS", "PATH=", MOAT_EXPERIMENTS_PROGRAM, "--write-docs"},
      folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.errors.find("--write-docs needs OpenSees (OPENSEES)"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace moat::experiments
