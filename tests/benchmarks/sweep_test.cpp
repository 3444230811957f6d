// The numbers that decide statements about curves.

#include "paper/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper/paper_building.hpp"

namespace moat::paper {
namespace {

TEST(RankCorrelation, SeesOnlyTheOrder) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {1, 8, 27, 1000}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {5, 3, 2, -9}), -1.0);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3}, {7, 7, 7}), 0.0);
}

/// Without ties it is 1 - 6 sum d^2/(n (n^2 - 1)): here d = 1, 1, 1, 1, 0.
TEST(RankCorrelation, AgreesWithSpearmansFormula) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4, 5}, {20, 10, 40, 30, 50}), 1.0 - 6.0 * 4.0 / (5.0 * 24.0));
}

/// Ranks of y: 0.5, 0.5, 2; Pearson's correlation with 0, 1, 2 by hand: 1.5/sqrt(2 * 1.5).
TEST(RankCorrelation, SharesTheRankOfEqualValues) {
  EXPECT_NEAR(rank_correlation({1, 2, 3}, {4, 4, 9}), 1.5 / std::sqrt(3.0), 1e-15);
}

TEST(Curves, FindTheirEnds) {
  EXPECT_DOUBLE_EQ(spread({2, 5, 4}), 2.5);
  EXPECT_EQ(position_of_minimum({3, 1, 2}), 1u);
  EXPECT_EQ(position_of_maximum({3, 1, 2}), 0u);
}

TEST(JudgeMotions, CountsTheRecordsInShort) {
  const SweepResult result{
      {1.0},
      {"A", "B"},
      StudyResult{StudyCases{StudyAxis::of_names("record", {"A", "B"})}, std::vector<CaseOutcome>(2)}};
  Exhibit exhibit;
  judge_motions(exhibit, result, {"1.1", "a claim", "a criterion", ""}, [](std::size_t motion) {
    return Answer{motion == 0, std::to_string(motion)};
  });
  ASSERT_EQ(exhibit.findings.size(), 1u);
  EXPECT_EQ(exhibit.findings.front().found, "A yes (0); B no (1)");
  EXPECT_EQ(exhibit.findings.front().in_short, "1 of 2 records");
  EXPECT_EQ(exhibit.findings.front().verdict, Verdict::partly);
}

/// The stated 2.5 s of the paper's building needs 1.93e7 N/m, ten times the printed value.
TEST(PaperBuilding, HasTheStatedIsolationPeriod) {
  EXPECT_NEAR(stiffness_for_period(2.5 * s, 5).si(), 1.93e7, 0.005e7);
  EXPECT_NEAR(isolator_damping(0.05, 2.5 * s, 5).si(), 7.67e5, 0.005e5);
}

}  // namespace
}  // namespace moat::paper
