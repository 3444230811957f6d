#include "materials/isolation/friction_pendulum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "materials/isolation/flat_slider.hpp"
#include "message_of.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

TEST(FrictionPendulum, PassesTheBattery) {
  FrictionPendulum law = FrictionPendulum::typical();
  law.friction = 0.05;
  expect_sound_spring(law.carrying(30 * MN), {});
  expect_sound_spring(FrictionPendulum::typical().carrying(30 * MN), {.rate = 0.02, .one_speed = true});
}

TEST(FlatSlider, PassesTheBattery) {
  expect_sound_spring(FlatSlider::typical().carrying(30 * MN), {});
  FlatSlider bare = FlatSlider::typical();
  bare.restoring_stiffness = {};
  expect_sound_spring(bare.carrying(1 * MN), {});
}

TEST(FrictionPendulum, HasThePeriodOfItsRadius) {
  const SlidingIsolator law = FrictionPendulum{.radius = 2.2352 * m, .friction = 0.05}.carrying(7 * MN);
  const double mass = 7e6 / standard_gravity;
  EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(mass / law.linear_stiffness(StiffnessStage::post_yield)), 2.999699,
              1e-6);
}

TEST(FrictionPendulum, HasTheLoopOfFriction) {
  const SlidingIsolator law = FrictionPendulum{.radius = 2 * m, .friction = 0.05}.carrying(1 * MN);
  LawPath<SlidingIsolator> path{law};
  path.move(0.2, 1.0);
  EXPECT_NEAR(path.force(), 0.2 / 2 * 1e6 + 0.05e6, 1e-3);
  const double before = path.dissipated();
  path.move(-0.2, 1.0);
  path.move(0.2, 1.0);
  EXPECT_NEAR(path.dissipated() - before, 4.0 * 0.05e6 * (0.2 - 0.001), 1e-4);
}

TEST(FrictionPendulum, ReportsFrictionAndSlip) {
  const SlidingIsolator law = FrictionPendulum::typical().carrying(1 * MN);
  EXPECT_NEAR(law.quantity(0, {}, 0.0, 0.01, 0.0).value, 0.06 - 0.03 * std::exp(-0.5), 1e-15);
  EXPECT_EQ(law.quantity(1, {.slip = 0.07}, 0.0, 0.0, 0.0).value, 0.07);
}

TEST(FrictionPendulum, RefusesParametersOutsideTheirRange) {
  const auto message = [](auto change) {
    FrictionPendulum law = FrictionPendulum::typical();
    change(law);
    return message_of([&] { law.check(Check{"Isolator", "bearings"}); });
  };
  EXPECT_EQ(message([](FrictionPendulum&) {}), "nothing was thrown");
  EXPECT_EQ(message([](FrictionPendulum& law) { law.radius = -1 * m; }),
            "Isolator \"bearings\": radius = -1 m is not allowed; it must be > 0 m and finite.");
  EXPECT_EQ(message([](FrictionPendulum& law) { law.friction = 0.4; }),
            "Isolator \"bearings\": friction.coefficient = 0.4 is not allowed; it must be > 0 and <= 0.3.");
  EXPECT_EQ(
      message([](FrictionPendulum& law) {
        law.friction = VelocityDependent{.slow = 0.08, .fast = 0.06, .rate = 50 * s / m};
      }),
      "Isolator \"bearings\": friction.slow = 0.08 is not allowed; it must be > 0 and <= 0.06. Friction at rest is "
      "at most that at high speed.");
}

TEST(Friction, HasExactSlopesOverSpeed) {
  for (const Friction& friction :
       {Friction{0.05}, Friction{VelocityDependent{.slow = 0.02, .fast = 0.07, .rate = 80 * s / m}},
        Friction{VelocityPressureDependent{.slow = 0.02,
        .at_zero_pressure = 0.12,
        .reduction = 0.06,
        .pressure_factor = 2e-8 * m * m / N,
        .area = 0.5 * m * m,
        .rate = 60 * s / m}},
        Friction{VelocityForceDependent{.slow_at_reference = 0.05,
        .fast_at_reference = 0.08,
        .reference_force = 1 * MN,
        .slow_exponent = 0.8,
        .fast_exponent = 0.9,
        .rate = 25 * s / m}}})
    for (const double speed : {0.001, 0.02, 0.3})
      for (const double force : {1e6, 2e7}) {
        const double h = 1e-4 * speed;
        EXPECT_NEAR(friction.at(speed, force).slope,
                    (friction.at(speed + h, force).value - friction.at(speed - h, force).value) / (2.0 * h), 1e-6);
      }
}

TEST(Friction, FollowsPressureAndForceAsStated) {
  const VelocityPressureDependent by_pressure{.slow = 0.02,
                                              .at_zero_pressure = 0.12,
                                              .reduction = 0.06,
                                              .pressure_factor = 2e-8 * m * m / N,
                                              .area = 0.5 * m * m,
                                              .rate = 60 * s / m};
  EXPECT_NEAR(by_pressure.fast(10e6), 0.12 - 0.06 * std::tanh(2e-8 * 10e6 / 0.5), 1e-15);
  EXPECT_NEAR(by_pressure.at(0.0, 10e6).value, 0.02, 1e-15);
  const VelocityForceDependent by_force{.slow_at_reference = 0.05,
                                        .fast_at_reference = 0.08,
                                        .reference_force = 1 * MN,
                                        .slow_exponent = 0.8,
                                        .fast_exponent = 0.7,
                                        .rate = 25 * s / m};
  EXPECT_NEAR(by_force.at(0.0, 4e6).value, 0.05 * std::pow(4.0, -0.2), 1e-15);
  EXPECT_NEAR(by_force.at(1e6, 4e6).value, 0.08 * std::pow(4.0, -0.3), 1e-15);
}

}  // namespace
}  // namespace moat::testing
