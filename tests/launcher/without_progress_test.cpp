#include "launcher/without_progress.hpp"

#include <gtest/gtest.h>

#include "launcher/process.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

TEST(WithoutProgress, LeavesWarningsAndErrorsOfABuild) {
  EXPECT_EQ(without_progress("ninja: Entering directory `build/dev'\n"
                             "[0/2] Re-checking globbed directories...\n"
                             "[1/4] Building CXX object good.o\n"
                             "[2/4] Building CXX object bad.o\n"
                             "FAILED: bad.o \n"
                             "/usr/bin/c++ -std=c++20 -o bad.o -c bad.cpp\n"
                             "bad.cpp:1:5: error: 'x' was not declared\n"
                             "    1 | int y = x;\n"
                             "[3/4] Building CXX object warned.o\n"
                             "warned.cpp:7:1: warning: unused\n"
                             "[4/4] Building CXX object last.o\n"
                             "ninja: build stopped: cannot make progress due to previous errors.\n"),
            "[2/4] Building CXX object bad.o\n"
            "FAILED: bad.o \n"
            "bad.cpp:1:5: error: 'x' was not declared\n"
            "    1 | int y = x;\n"
            "[3/4] Building CXX object warned.o\n"
            "warned.cpp:7:1: warning: unused\n");
}

TEST(WithoutProgress, LeavesTheFindingsOfClangTidy) {
  EXPECT_EQ(without_progress("clang-tidy-14 -p=build /m/good.cpp\n"
                             "\n"
                             "12 warnings generated.\n"
                             "/usr/bin/clang-tidy -p=build /m/bad.cpp\n"
                             "/m/bad.cpp:3:1: error: unused parameter [misc-unused-parameters]\n"
                             "Suppressed 12 warnings (12 in non-user code).\n"
                             "Use -header-filter=.* to display errors from all non-system headers.\n"
                             "1 warning treated as error\n"),
            "/usr/bin/clang-tidy -p=build /m/bad.cpp\n"
            "/m/bad.cpp:3:1: error: unused parameter [misc-unused-parameters]\n");
}

TEST(WithoutProgress, LeavesTheTestsThatFailed) {
  EXPECT_EQ(without_progress("      Start  1: a.b\n"
                             " 1/2 Test  #1: a.b ......................   Passed    0.01 sec\n"
                             "      Start  2: a.c\n"
                             " 2/2 Test  #2: a.c ......................***Failed    0.01 sec\n"
                             "expected 1\n"),
            " 2/2 Test  #2: a.c ......................***Failed    0.01 sec\n"
            "expected 1\n");
}

TEST(WithoutProgress, LeavesALogThatHoldsNothingElse) {
  EXPECT_EQ(without_progress("-- Configuring done\n"), "-- Configuring done\n");
}

using NinjaLog = moat::testing::InTemporaryFolder;

TEST_F(NinjaLog, HoldsNoStepThatWentWell) {
  write_text(folder / "build.ninja",
             "rule run\n  command = $do\n  description = step $out\n"
             "build one: run\n  do = touch one\n"
             "build two: run\n  do = echo no such file; false\n"
             "build three: run\n  do = touch three\n");
  EXPECT_NE(run_into(folder / "log", {NINJA, "-C", folder, "-j1", "-k", "0"}), 0);
  const std::string log = without_progress(text_of(folder / "log"));
  EXPECT_NE(log.find("step two\nFAILED: two \nno such file\n"), std::string::npos) << log;
  EXPECT_EQ(lines_of(log).size(), 3u) << log;
}

}  // namespace
}  // namespace moat::launcher
