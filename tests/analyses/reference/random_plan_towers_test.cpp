// Towers in plan drawn at random: the error of the peaks with the default tolerance, and that axes do not matter.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

struct Case {
  Model model;
  GroundMotion motion;
};

// Turned about the origin with its motion.
Case tower(unsigned seed, Angle turn = {}) {
  std::mt19937 generator{seed};
  const auto between = [&](double lowest, double highest) {
    return std::uniform_real_distribution<>{lowest, highest}(generator);
  };
  const Length width = between(10, 30) * m, depth = between(8, 20) * m;
  const auto place = [&](double x, double y) { return turned({x * width, y * depth}, turn); };
  const Angle quarter = std::numbers::pi / 4 * rad;
  const Time period = between(0.8, 2.0) * s;
  const int storeys = static_cast<int>(between(1, 4.99));
  const Mass floor_mass = between(200, 900) * tonne, base_mass = between(300, 900) * tonne;
  const double offset_x = between(-0.08, 0.08), offset_y = between(-0.08, 0.08);
  const StoreyColumn column{.stiffness = between(50, 200) * MN / m};
  const Force strength = between(100, 300) * kN;
  const Stiffness post_yield = between(1, 2.5) * MN / m;
  const bool rounded = between(0, 1) < 0.5;
  std::vector<ColumnLine> columns;
  std::vector<PlanBearings::Placed> bearings;
  for (const double x : {-0.5, 0.0, 0.5})
    for (const double y : {-0.5, 0.5}) {
      columns.push_back({place(x, y), column});
      if (rounded)
        bearings.emplace_back(place(x, y), BiaxialBoucWen{.characteristic_strength = strength,
                                                          .yield_displacement = 1 * cm,
                                                          .post_yield_stiffness = post_yield});
      else
        bearings.emplace_back(place(x, y), LeadRubberBearing{.yield_force = strength,
                                                             .yield_displacement = 1 * cm,
                                                             .post_yield_stiffness = post_yield});
    }
  Model model;
  const auto added = add(model, PlanBuilding{.outline = turned(rectangle(width, depth), turn),
                                             .storeys = storeys,
                                             .floor_mass = floor_mass,
                                             .mass_offset = place(offset_x, offset_y),
                                             .columns = PlanColumns{columns},
                                             .damping = RayleighDamping{.ratio = 0.05},
                                             .base_mass = base_mass,
                                             .bearings = PlanBearings{bearings}});
  add(model, PlanMoat{.around = added.base,
                      .clearance = between(8, 25) * cm,
                      .law = HertzDamp{.stiffness = between(0.5e9, 3e9) * N / m_3_2, .restitution = between(0.4, 0.8)},
                      .friction = between(0.0, 0.6)});
  const double degrees = between(0, 359), second = between(0.3, 1.0);
  const PlanMotion motion{near_fault_pulse({.pulse_period = period, .phase = quarter}),
                          near_fault_pulse({.pulse_period = period, .phase = -quarter}).scaled_by(second)};
  PlanMotion scaled = motion.scaled_to_larger_pga(between(0.3, 0.6) * g);
  scaled.incidence = std::fmod(degrees + turn / deg, 360.0) * deg;
  return {std::move(model), scaled.resolved()};
}

struct Solution {
  std::vector<Peak> peaks;
  SolverStatistics statistics;
};

Solution solve(const Case& each, const TransientOptions& options) {
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
  const Case each = tower(GetParam());
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
  const Solution plain = solve(tower(GetParam()), {}), other = solve(tower(GetParam(), turn), {});
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
        std::ranges::any_of(solve(tower(seed), {}).peaks,
                            [](const Peak& peak) { return peak.quantity == "impact_force" && peak.value > 0.0; })
            ? 1
            : 0;
  EXPECT_GE(pounding, 9);
}

}  // namespace
}  // namespace moat::testing
