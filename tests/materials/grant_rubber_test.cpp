#include "materials/isolation/grant_rubber.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "message_of.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

const GrantRubber specimen = GrantRubber::typical();

TEST(GrantRubber, PassesTheBattery) {
  const SpringTrial trial{.deformation = 0.1};
  expect_tangents(specimen, trial);
  expect_purity(specimen, trial);
  expect_symmetry(specimen, trial);
  expect_independence_of_pieces(specimen, trial);
}

TEST(GrantRubber, KnowsTheRateOfItsFittedShare) {
  GrantRubber fitted = specimen;
  fitted.fitted_deformation = 5 * cm;
  expect_rates_of_quantities(fitted, {.deformation = 0.1});
}

TEST(GrantRubber, BalancesItsEnergyAlongShortMoves) {
  LawPath<GrantRubber> path{specimen};
  double from = 0.0;
  for (const double target : {0.09, -0.05, 0.02, -0.09, 0.07, 0.03}) {
    constexpr int pieces = 200;
    for (int i = 1; i <= pieces; ++i) path.move(from + (target - from) * i / pieces, 1.0);
    from = target;
    EXPECT_NEAR(path.work(), path.stored() + path.dissipated(), 1e-6 * path.work()) << target;
  }
  EXPECT_GT(path.dissipated(), 0.5 * path.work());
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

TEST(GrantRubber, RefusesAnElasticForceThatFalls) {
  GrantRubber law = specimen;
  law.a2 = -1e8 * N / (m * m * m);
  EXPECT_EQ(
      message_of([&] {
        law.check(Check{"Isolator", "bearings"});
      }),
      "Isolator \"bearings\": a2 = -1e+08 N/m^3 is not allowed; it must be so that a1 + 3 a2 d^2 + 5 a3 d^4 >= 0 at "
      "every d. The elastic force must grow with d.");
}

}  // namespace
}  // namespace moat::testing
