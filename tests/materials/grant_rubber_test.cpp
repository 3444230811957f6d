#include "materials/isolation/grant_rubber.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

const GrantRubber specimen = GrantRubber::typical();

TEST(GrantRubber, KnowsTheRateOfItsFittedShare) {
  GrantRubber fitted = specimen;
  fitted.fitted_deformation = 5 * cm;
  expect_rates_of_quantities(fitted, {.deformation = 0.1});
}

TEST(GrantRubber, HasTheForcesOfTheClosedForm) {
  struct Case {
    double deformation, elastic, hysteretic;
  };
  for (const auto& [d, elastic, hysteretic] : {Case{22.86e-3, 5313.328, 3449.803}, Case{45.72e-3, 10331.502, 6141.504},
                                               Case{91.44e-3, 19436.470, 15026.203}}) {
    GrantRubber::State trial;
    const double force = specimen.evaluate({}, d, 1.0, trial).force;
    EXPECT_NEAR(trial.hysteretic, hysteretic, 1e-3) << d;
    EXPECT_NEAR(force - trial.hysteretic, elastic, 1e-3) << d;
  }
}

TEST(GrantRubber, UnloadsInOneStepAsTheClosedFormSays) {
  GrantRubber::State loaded, half, none;
  specimen.evaluate({}, 45.72e-3, 1.0, loaded);
  const double force = specimen.evaluate(loaded, 22.86e-3, -1.0, half).force;
  EXPECT_NEAR(half.damage.scragging, 22.86e-3, 1e-15);
  EXPECT_NEAR(half.damage.mullins, 22.86e-3, 1e-15);
  const GrantRubber::Wear wear = specimen.wear_of(half.damage);
  EXPECT_NEAR(wear.elastic, 0.99876147 * 0.99827093, 1e-8);  // K_S1 K_M
  EXPECT_NEAR(wear.bound, 0.99570814, 1e-8);
  EXPECT_NEAR(half.hysteretic, -1787.422, 1e-3);
  EXPECT_NEAR(force - half.hysteretic, 5297.571, 1e-3);
  EXPECT_NEAR(specimen.evaluate(loaded, 0.0, -1.0, none).force, -2912.202, 1e-3);
}

}  // namespace
}  // namespace moat::testing
