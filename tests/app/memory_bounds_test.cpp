// The memory of results: differences of the largest memory of two runs, so that the program itself does not count.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

using testing::ProgramResult;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;  // freed memory is kept
#else
constexpr bool is_sanitized = false;
#endif

class MemoryBounds : public testing::InTemporaryFolder {
 protected:
  ProgramResult run(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(),
                     {"--quiet", "--frame-interval", "0 s", "--no-sensitivity", "--out", "out", "--force"});
    ProgramResult result = testing::run_program(program, arguments, folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }
  double memory_of(const std::string& program, const std::vector<std::string>& arguments) {
    return run(program, arguments).largest_memory;
  }
};

// Both are longer than the rows for which room is reserved at once.
TEST_F(MemoryBounds, ARowOf45ColumnsTakes500Bytes) {
  if (is_sanitized) GTEST_SKIP() << "not for the memory of sanitizers";
  const double less = memory_of(FIRST_TOUR, {"--end", "900 s"}), more = memory_of(FIRST_TOUR, {"--end", "1500 s"});
  const std::string heads = testing::text_of(folder / "out" / "histories.csv");
  const auto columns = 1 + std::count(heads.begin(), std::find(heads.begin(), heads.end(), '\n'), ',');
  constexpr double rows = 600.0 / 0.005;
  EXPECT_LE((more - less) / rows / static_cast<double>(columns), 500.0 / 45.0);
}

TEST_F(MemoryBounds, ADegreeOfFreedomTakes20Kilobytes) {
  if (is_sanitized) GTEST_SKIP() << "not for the memory of sanitizers";
  const double less = memory_of(STREET_SCRIPT, {"--end", "0.05 s", "--buildings", "200"}),
               more = memory_of(STREET_SCRIPT, {"--end", "0.05 s", "--buildings", "600"});
  EXPECT_LE((more - less) / 4000.0, 20e3);
}

// As on a machine with little memory.
TEST_F(MemoryBounds, HistoriesAreThinnedToFit) {
  if (is_sanitized) GTEST_SKIP() << "sanitizers take more address space than any limit";
  const ProgramResult result = testing::run_program(
      "/bin/bash",
      {"-c", "ulimit -v 900000; exec \"$0\" --quiet --end '4000 s' --frame-interval '0 s' --no-sensitivity --out out",
       FIRST_TOUR},
      folder);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.errors.find("Histories have a row every 0.01"), std::string::npos) << result.errors;
  EXPECT_NE(testing::text_of(folder / "out" / "summary.json").find("instead of every 0.005 s"), std::string::npos);
  EXPECT_LT(result.largest_memory, 0.9e9);
}

TEST_F(MemoryBounds, FramesWithoutNumberAreRefused) {
  const ProgramResult result =
      testing::run_program(FIRST_TOUR, {"--end", "10 s", "--frame-interval", "1e-6 s", "--out", "out"}, folder);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("number of frames (end / frame-interval) = "), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("Give a longer --frame-interval"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace moat
