#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

TEST(FlatSlider, PassesTheBattery) {
  FlatSlider bare = FlatSlider::typical();
  bare.restoring_stiffness = {};
  expect_sound_spring(bare.carrying(1 * MN), {});
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
