// The lines of a run on the terminal.

#include "app/results.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "in_folder.hpp"

namespace moat {
namespace {

TEST(TerminalSummary, AlignsPeriodsOfAnyName) {
  CaseResult result;
  result.periods = {{"fixed base", 0.5}, {"a building of a long name: first mode, post-yield bearings", 2.5}};
  const std::string text = terminal_summary(result);
  EXPECT_NE(text.find("  fixed base                                                  0.500\n"
                      "  a building of a long name: first mode, post-yield bearings  2.500\n"),
            std::string::npos)
      << text;
}

TEST(TerminalSummary, SaysWhereTheErrorBarsComeFrom) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.5328, "m", 4.5, 0.0002}};
  result.error_bars = {.checked = true,
                       .companion = "Finer.",
                       .companion_impacts = 1,
                       .companion_solver = {.accepted_steps = 123, .cpu_seconds = 0.5}};
  EXPECT_NE(terminal_summary(result).find(
                "  base  53.28 +- 0.02   at 4.500 s\n\n"
                "+- estimated numerical error, from a second run with finer steps (1 impact, 123 steps, 0.5 s)\n"),
            std::string::npos)
      << terminal_summary(result);
}

TEST(TerminalSummary, HasTheSensitivityToContactsBehindThePeaks) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.5, "m", 4.5}};
  result.solver.cpu_seconds = 2.0;
  result.contact_sensitivity.runs_left_out = 6;
  const std::string text = terminal_summary(result);
  const std::size_t peaks = text.find("peak displacement"),
                    sensitivity =
                        text.find("Sensitivity to contact parameters: not computed, at most 12 s; --sensitivity"),
                    energy = text.find("energy [kJ]");
  EXPECT_LT(peaks, sensitivity) << text;
  EXPECT_LT(sensitivity, energy) << text;
}

using WriteResults = testing::InFolder;

TEST_F(WriteResults, ReportsItsProgress) {
  std::vector<double> done;
  std::string last;
  write_results({}, folder, [&](double parts, double all, const std::string& written) {
    done.push_back(parts / all);
    last = written;
  });
  ASSERT_EQ(done.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_EQ(done.back(), 1.0);
  EXPECT_EQ(last, " (summary.json)");
  for (const char* name : {"summary.json", "histories.csv", "histories.vtt", "impacts.csv", "peaks.csv", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

}  // namespace
}  // namespace moat
