#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moat.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// E/(C w^alpha A^(1 + alpha)) of a sine.
TEST(NonlinearViscous, HasTheEnergyOfTheClosedForm) {
  struct Case {
    double exponent, energy;
  };
  for (const auto& [exponent, energy] : {Case{0.2, 3.774362}, Case{0.3, 3.674572}, Case{0.35, 3.627472},
                                         Case{0.5, 3.496077}, Case{1.0, std::numbers::pi}}) {
    const NonlinearViscous law{.reference_force = 1 * N, .exponent = exponent, .rounding_speed = 1e-9 * m / s};
    constexpr int steps = 400000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double v = std::cos(2.0 * std::numbers::pi * (i + 0.5) / steps);
      sum += law.dissipation_rate({}, 0.0, v) * 2.0 * std::numbers::pi / steps;
    }
    EXPECT_NEAR(sum, energy, 1e-6) << exponent;
  }
}

TEST(NonlinearViscous, HasTheForceAtItsReferenceSpeed) {
  const NonlinearViscous law{
      .reference_force = 1.5 * MN, .exponent = 0.3, .reference_speed = 0.5 * m / s, .rounding_speed = 1e-6 * m / s};
  NoState none;
  EXPECT_NEAR(law.evaluate({}, 0.0, 0.5, none).force, 1.5e6, 1e-4);
  EXPECT_NEAR(law.evaluate({}, 0.0, -1.0, none).force, -1.5e6 * std::pow(2.0, 0.3), 1e-4);
}

TEST(StiffeningSpring, ActsBeyondItsStart) {
  LawPath<StiffeningSpring> path{StiffeningSpring::typical()};
  path.move(0.19, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(-0.26, 1.0);
  EXPECT_NEAR(path.force(), -0.06 * 20e6, 1e-6);
  path.move(-0.19, 1.0);
  EXPECT_EQ(path.force(), 0.0) << "it does not pull";
}

TEST(YieldingStorey, ReportsDuctilityAndResidualDrift) {
  LawPath<YieldingStorey> path{YieldingStorey::typical()};
  path.move(0.03, 1.0);
  EXPECT_NEAR(path.force(), 6e6 + 0.05e9 * 0.024, 1e-3);
  const YieldingStorey law = YieldingStorey::typical();
  EXPECT_NEAR(law.quantity(0, path.state(), 0.03, 0.0, 0.0).value, 5.0, 1e-12);
  const double residual = law.quantity(1, path.state(), 0.03, 0.0, 0.0).value;
  path.move(residual, 1.0);
  EXPECT_NEAR(path.force(), 0.0, 1e-3);
}

TEST(PDelta, HasTheStiffnessOfItsWeight) {
  EXPECT_NEAR(1.0 / std::sqrt(1.0 + PDelta{.weight = 20 * MN, .height = 3.5 * m}.stiffness() / 200e6), 1.0145993, 5e-8);
}

TEST(Repeated, IsTheSumOfEqualLaws) {
  const Repeated<YieldingStorey> five{YieldingStorey::typical(), 5.0};
  expect_sound_spring(five, {.deformation = 0.05});
  LawPath<YieldingStorey> one{YieldingStorey::typical()};
  LawPath<Repeated<YieldingStorey>> many{five};
  for (const double target : {0.03, -0.01, 0.02}) {
    one.move(target, 0.1);
    many.move(target, 0.1);
    EXPECT_DOUBLE_EQ(many.force(), 5.0 * one.force());
    EXPECT_NEAR(many.dissipated(), 5.0 * one.dissipated(), 1e-6);
    EXPECT_NEAR(many.stored(), 5.0 * one.stored(), 1e-6);
  }
  EXPECT_EQ(quantities_of(five).size(), 2U);
}

}  // namespace
}  // namespace moat::testing
