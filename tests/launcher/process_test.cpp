#include "launcher/process.hpp"

#include <gtest/gtest.h>

#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

using Process = moat::testing::InTemporaryFolder;

TEST_F(Process, GivesTheExitCode) {
  EXPECT_EQ(run({"true"}), 0);
  EXPECT_EQ(run({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(run({"sh", "-c", "kill -TERM $$"}), 128 + 15);
  EXPECT_EQ(run({"/no/such/program"}), 127);
}

TEST_F(Process, WritesAllOutputIntoALog) {
  EXPECT_EQ(run_into(folder / "new" / "log", {"sh", "-c", "echo one; echo two >&2; cat"}), 0);
  EXPECT_EQ(text_of(folder / "new" / "log"), "one\ntwo\n");
}

TEST_F(Process, KeepsStandardOutput) {
  const Output output = output_of({"sh", "-c", "echo 'a  b'; echo no >&2; exit 3"});
  EXPECT_EQ(output.text, "a  b\n");
  EXPECT_EQ(output.exit_code, 3);
}

}  // namespace
}  // namespace moat::launcher
