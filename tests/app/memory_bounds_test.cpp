// The memory of results: differences of the largest memory of two runs, so that the program itself does not count.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "run_program.hpp"
#include "study_runs.hpp"

namespace moat {
namespace {

using testing::ProgramResult;

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
  const double less = memory_of(FIRST_TOUR, {"--end", "900 s"}), more = memory_of(FIRST_TOUR, {"--end", "1500 s"});
  std::string heads;
  std::getline(std::ifstream{folder / "out" / "histories.csv"}, heads);
  const auto columns = 1 + std::ranges::count(heads, ',');
  constexpr double rows = 600.0 / 0.005;
  const double of_value = (more - less) / rows / static_cast<double>(columns);
  EXPECT_LE(of_value, 500.0 / 45.0);
  EXPECT_GE(of_value, 0.5 * sizeof(double)) << "the rows were not kept";
}

// With the second run for error bars.
TEST_F(MemoryBounds, ADegreeOfFreedomTakes7500Bytes) {
  const double less = memory_of(STREET_SCRIPT, {"--check", "--end", "0.05 s", "--buildings", "200"}),
               more = memory_of(STREET_SCRIPT, {"--check", "--end", "0.05 s", "--buildings", "600"});
  EXPECT_LE((more - less) / 4000.0, 7.5e3);
  EXPECT_GE((more - less) / 4000.0, 500.0) << "the buildings were not kept";
}

class MemoryBoundsOfStudies : public testing::StudyRuns {};

// Through Script, with its file and its table: 50 numbers of 8 bytes are the least. The results of the smaller study
// are larger than the memory that was freed before.
TEST_F(MemoryBoundsOfStudies, ACaseOf50ResultsTakes1Kilobyte) {
  const std::string record = write_record("record.AT2", "0 0.1 0 0");
  const auto memory_of = [&](const std::string& gaps) {
    const ProgramResult result =
        run({"--numbers", gaps, "--inside", record, "--out", "with_" + gaps, "--threads", "1", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result.largest_memory;
  };
  for (const char* cases_are : {"computed", "read from their file"}) {
    const double less = memory_of("400"), more = memory_of("1000"), cases = 600.0 * 20.0;
    EXPECT_LE((more - less) / cases, 1e3) << cases_are;
    EXPECT_GE((more - less) / cases, 50.0 * sizeof(double)) << cases_are << ": the results were not kept";
  }
}

// As on a machine with little memory.
TEST_F(MemoryBounds, HistoriesAreThinnedToFit) {
  const ProgramResult result = testing::run_program(
      "/bin/bash",
      {"-c", "ulimit -v 900000; exec \"$0\" --quiet --end '4000 s' --frame-interval '0 s' --no-sensitivity --out out",
       FIRST_TOUR},
      folder);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const std::string words = "Histories have a row every ";
  const std::size_t at = result.errors.find(words);
  ASSERT_NE(at, std::string::npos) << result.errors;
  const double interval = std::stod(result.errors.substr(at + words.size()));
  EXPECT_GE(interval, 0.01);
  EXPECT_NEAR(std::remainder(interval, 0.005), 0.0, 1e-12);
  EXPECT_GT(result.largest_memory, 4000.0 / interval * 45.0 * sizeof(double)) << "the rows were not kept";
  EXPECT_NE(testing::text_of(folder / "out" / "summary.json").find("instead of every 0.005 s"), std::string::npos);
  EXPECT_LT(result.largest_memory, 0.9e9);
}

}  // namespace
}  // namespace moat
