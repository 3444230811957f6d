#include "materials/bilinear.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "materials/contact/contact_state.hpp"

namespace moat {
namespace {

using namespace units;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

static_assert(LawWithRegimes<Bilinear>);
static_assert(!ContactLaw<Bilinear>);

TEST(Bilinear, IsLinearWithinARegime) {
  Bilinear::State trial;
  const Bilinear::State elastic{0.003, 0}, sliding{0.003, 1};
  for (const double deformation : {-0.5, 0.0, 0.2}) {
    const Response response = bearing.evaluate(elastic, deformation, 1.0, trial);
    EXPECT_NEAR(response.force, 19.3e6 * deformation + (1.93e8 - 1.93e7) * (deformation - 0.003), 1e-6);
    EXPECT_EQ(response.stiffness, 1.93e8);
    EXPECT_EQ(bearing.evaluate(sliding, deformation, 1.0, trial).stiffness, 1.93e7);
    EXPECT_NEAR(trial.slip, deformation - 0.01, 1e-15);
  }
}

TEST(Bilinear, TheForceIsContinuousAtBothCorners) {
  Bilinear::State trial;
  const double yield = 0.01 * (1.0 + Bilinear::threshold);
  const Bilinear::State elastic{};
  const Bilinear::State sliding = bearing.next_regime(elastic, yield, 0.1);
  EXPECT_EQ(sliding.direction, 1);
  EXPECT_NEAR(bearing.evaluate(elastic, yield, 0.1, trial).force, bearing.evaluate(sliding, yield, 0.1, trial).force,
              1e-8 * 1.93e6);
  const Bilinear::State unloading = bearing.next_regime(sliding, 0.03, -1e-13);
  EXPECT_EQ(unloading.direction, 0);
  EXPECT_NEAR(bearing.evaluate(sliding, 0.03, 0.0, trial).force, bearing.evaluate(unloading, 0.03, 0.0, trial).force,
              1e-6);
  EXPECT_GT(bearing.regime_margin(unloading, 0.03, -1e-13), 0.0);
}

}  // namespace
}  // namespace moat
