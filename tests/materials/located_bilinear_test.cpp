#include "materials/located_bilinear.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "materials/contact_state.hpp"

namespace moat {
namespace {

using namespace units;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
const LocatedBilinear located{bearing};

static_assert(LawWithRegimes<LocatedBilinear>);
static_assert(!ContactLaw<LocatedBilinear>);

// Leads both laws along the same small moves; the located one changes regime where its margin says so.
TEST(LocatedBilinear, FollowsTheSameLoopAsBilinear) {
  Bilinear::State plain, plain_trial;
  LocatedBilinear::State state, trial;
  double before = 0.0;
  const int moves = 40000;
  for (int i = 1; i <= moves; ++i) {
    const double phase = 6.0 * i / moves;
    const double deformation = 0.05 * phase / 6.0 * std::sin(2.0 * 3.14159265358979 * phase);
    const double rate = deformation - before;
    while (located.regime_margin(state, deformation, rate) < 0.0)
      state = located.next_regime(state, state.direction == 0 ? deformation : before, rate);
    const double force = located.evaluate(state, deformation, rate, trial).force;
    const double expected = bearing.evaluate(plain, deformation, rate, plain_trial).force;
    // A move of 10 micrometres at 193 MN/m: the corners are not located here.
    ASSERT_NEAR(force, expected, 2.0 * 1.93e8 * std::abs(rate) + 1.0) << i;
    state = trial;
    plain = plain_trial;
    before = deformation;
  }
}

TEST(LocatedBilinear, IsLinearWithinARegime) {
  LocatedBilinear::State trial;
  const LocatedBilinear::State elastic{0.003, 0}, sliding{0.003, 1};
  for (const double deformation : {-0.5, 0.0, 0.2}) {
    const Response response = located.evaluate(elastic, deformation, 1.0, trial);
    EXPECT_NEAR(response.force, 19.3e6 * deformation + (1.93e8 - 1.93e7) * (deformation - 0.003), 1e-6);
    EXPECT_EQ(response.stiffness, 1.93e8);
    EXPECT_EQ(located.evaluate(sliding, deformation, 1.0, trial).stiffness, 1.93e7);
    EXPECT_NEAR(trial.slip, deformation - 0.01, 1e-15);
  }
}

TEST(LocatedBilinear, TheForceIsContinuousAtBothCorners) {
  LocatedBilinear::State trial;
  const double yield = 0.01 * (1.0 + LocatedBilinear::threshold);
  const LocatedBilinear::State elastic{};
  const LocatedBilinear::State sliding = located.next_regime(elastic, yield, 0.1);
  EXPECT_EQ(sliding.direction, 1);
  EXPECT_NEAR(located.evaluate(elastic, yield, 0.1, trial).force, located.evaluate(sliding, yield, 0.1, trial).force,
              1e-8 * 1.93e6);
  const LocatedBilinear::State unloading = located.next_regime(sliding, 0.03, -1e-13);
  EXPECT_EQ(unloading.direction, 0);
  EXPECT_NEAR(located.evaluate(sliding, 0.03, 0.0, trial).force, located.evaluate(unloading, 0.03, 0.0, trial).force,
              1e-6);
  EXPECT_GT(located.regime_margin(unloading, 0.03, -1e-13), 0.0);
}

}  // namespace
}  // namespace moat
