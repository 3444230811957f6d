#include "launcher/process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "launcher/stop.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;
using Process = moat::testing::InTemporaryFolder;

TEST_F(Process, GivesTheExitCode) {
  EXPECT_EQ(run({"true"}), 0);
  EXPECT_EQ(run({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(run({"sh", "-c", "kill -TERM $$"}), 128 + 15);
  EXPECT_EQ(run({"/no/such/program"}), 127);
}

TEST_F(Process, WritesAllOutputIntoALog) {
  EXPECT_EQ(run({"sh", "-c", "echo one; echo two >&2; cat"}, folder / "new" / "log"), 0);
  EXPECT_EQ(text_of(folder / "new" / "log"), "one\ntwo\n");
}

// A program of this test that became another one.
moat::testing::ProgramResult became(const std::string& script) {
  const fs::path file = fs::temp_directory_path() / ("moat_became_" + std::to_string(::getpid()));
  const pid_t child = ::fork();
  if (child == 0) {
    become("/bin/sh", "name of it", {"-c", script + " >'" + file.string() + "'"});
    std::_Exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  moat::testing::ProgramResult result{WEXITSTATUS(status), text_of(file), ""};
  fs::remove(file);
  return result;
}

TEST(Becoming, GivesTheExitCodeOfTheProgram) {
  EXPECT_EQ(became("exit 4").exit_code, 4);
  EXPECT_THROW(become("/no/such/program", "x", {}), Stop);
}

TEST(Becoming, AsksForLargePagesUnlessTheUserSetThem) {
  ::unsetenv("GLIBC_TUNABLES");
  EXPECT_TRUE(became("printf %s \"$GLIBC_TUNABLES\"").output.starts_with("glibc.malloc.hugetlb=1:"));
  ::setenv("GLIBC_TUNABLES", "glibc.malloc.check=0", 1);
  EXPECT_EQ(became("printf %s \"$GLIBC_TUNABLES\"").output, "glibc.malloc.check=0");
  ::unsetenv("GLIBC_TUNABLES");
}

}  // namespace
}  // namespace moat::launcher
