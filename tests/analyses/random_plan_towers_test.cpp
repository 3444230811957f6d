// Towers in plan drawn at random: what the default tolerance leaves of the peaks' error.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analyses/transient.hpp"
#include "elements/lead_rubber_bearing.hpp"
#include "materials/impact_laws.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/plan_motion.hpp"
#include "output/peak_recorder.hpp"
#include "structures/plan_building.hpp"
#include "structures/plan_moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

struct Case {
  Model model;
  GroundMotion motion;
};

Case tower(unsigned seed) {
  std::mt19937 generator{seed};
  const auto between = [&](double lowest, double highest) {
    return std::uniform_real_distribution<>{lowest, highest}(generator);
  };
  const Length width = between(10, 30) * m, depth = between(8, 20) * m;
  const Angle quarter = std::numbers::pi / 4 * rad;
  const Time period = between(0.8, 2.0) * s;
  Model model;
  const auto added =
      add(model, PlanBuilding{.outline = rectangle(width, depth),
                              .storeys = static_cast<int>(between(1, 4.99)),
                              .floor_mass = between(200, 900) * tonne,
                              .mass_offset = {between(-0.08, 0.08) * width, between(-0.08, 0.08) * depth},
                              .columns = grid(3, 2, {.stiffness = between(50, 200) * MN / m}),
                              .damping = RayleighDamping{.ratio = 0.05},
                              .base_mass = between(300, 900) * tonne,
                              .bearings = grid(3, 2,
                                               LeadRubberBearing{.yield_force = between(100, 300) * kN,
                                                                 .yield_displacement = 1 * cm,
                                                                 .post_yield_stiffness = between(1, 2.5) * MN / m})});
  add(model, PlanMoat{.around = added.base,
                      .clearance = between(8, 25) * cm,
                      .law = HertzDamp{.stiffness = between(0.5e9, 3e9) * N / m_3_2, .restitution = between(0.4, 0.8)},
                      .friction = between(0.0, 0.6)});
  const PlanMotion motion{near_fault_pulse({.pulse_period = period, .phase = quarter}),
                          near_fault_pulse({.pulse_period = period, .phase = -quarter}).scaled_by(between(0.3, 1.0)),
                          between(0, 359) * deg};
  return {std::move(model), motion.scaled_to_larger_pga(between(0.3, 0.6) * g)};
}

std::vector<Peak> peaks_of(const Case& each, const TransientOptions& options) {
  Model model = each.model;
  Transient analysis{model, each.motion, options};
  PeakRecorder recorder{model};
  analysis.attach(recorder);
  analysis.run();
  return recorder.peaks();
}

class RandomPlanTowers : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomPlanTowers, HavePeaksThatATighterToleranceHardlyMoves) {
  const Case each = tower(GetParam());
  const std::vector<Peak> peaks = peaks_of(each, {}),
                          tight = peaks_of(each, {.tolerance = 1e-6, .steps_per_contact = 128});
  ASSERT_EQ(peaks.size(), tight.size());
  bool pounds = false;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    pounds = pounds || (tight[i].quantity == "impact_force" && tight[i].magnitude() > 0.0);
    EXPECT_NEAR(peaks[i].magnitude(), tight[i].magnitude(), 2e-3 * tight[i].magnitude())
        << peaks[i].quantity << " " << peaks[i].where;
  }
  EXPECT_TRUE(pounds);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPlanTowers, ::testing::Range(101u, 107u));

}  // namespace
}  // namespace moat::testing
