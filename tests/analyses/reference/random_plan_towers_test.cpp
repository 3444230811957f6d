// Towers in plan drawn at random: the error of the peaks with the default tolerance, and that axes do not matter.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "moat.hpp"
#include "random_tower.hpp"

namespace moat::testing {
namespace {

using namespace units;

struct Solution {
  std::vector<Peak> peaks;
  SolverStatistics statistics;
};

Solution solve(const Tower& each, const TransientOptions& options) {
  Model model = each.model;
  Transient analysis{model, each.motion, options};
  PeakRecorder recorder{model};
  analysis.attach(recorder);
  analysis.run();
  return {recorder.peaks(), analysis.statistics()};
}

bool is_component(const Peak& peak) { return peak.quantity.ends_with("_x") || peak.quantity.ends_with("_y"); }

class RandomPlanTowers : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomPlanTowers, HavePeaksThatATighterToleranceHardlyMoves) {
  const Tower each = random_tower(GetParam());
  const Solution normal = solve(each, {}), tight = solve(each, {.tolerance = 1e-7, .steps_per_contact = 256});
  ASSERT_EQ(normal.peaks.size(), tight.peaks.size());
  for (std::size_t i = 0; i < normal.peaks.size(); ++i) {
    const Peak &peak = normal.peaks[i], &exact = tight.peaks[i];
    EXPECT_NEAR(peak.magnitude(), exact.magnitude(), 1e-3 * exact.magnitude()) << peak.quantity << " " << peak.where;
  }
}

TEST_P(RandomPlanTowers, TakeTheSameStepsAndPeaksWhereTheyAreTurned) {
  std::mt19937 generator{GetParam()};
  const Angle turn = std::uniform_real_distribution<>{0.1, 6.2}(generator)*rad;
  const Solution plain = solve(random_tower(GetParam()), {}),
                 other = solve(random_tower(GetParam(), {.turn = turn}), {});
  EXPECT_EQ(plain.statistics.accepted_steps, other.statistics.accepted_steps);
  EXPECT_EQ(plain.statistics.repeated_steps, other.statistics.repeated_steps);
  EXPECT_EQ(plain.statistics.events, other.statistics.events);
  ASSERT_EQ(plain.peaks.size(), other.peaks.size());
  for (std::size_t i = 0; i < plain.peaks.size(); ++i) {
    const Peak &peak = plain.peaks[i], &turned_peak = other.peaks[i];
    if (is_component(peak)) continue;
    EXPECT_NEAR(turned_peak.magnitude(), peak.magnitude(), 1e-9 * peak.magnitude())
        << peak.quantity << " " << peak.where;
  }
}

constexpr unsigned first_seed = 101, last_seed = 112;
INSTANTIATE_TEST_SUITE_P(Seeds, RandomPlanTowers, ::testing::Range(first_seed, last_seed + 1));

TEST(RandomPlanTowersTogether, NearlyAllPound) {
  int pounding = 0;
  for (unsigned seed = first_seed; seed <= last_seed; ++seed)
    pounding +=
        std::ranges::any_of(solve(random_tower(seed), {}).peaks,
                            [](const Peak& peak) { return peak.quantity == "impact_force" && peak.value > 0.0; })
            ? 1
            : 0;
  EXPECT_GE(pounding, 9);
}

}  // namespace
}  // namespace moat::testing
