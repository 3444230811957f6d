// Bearings of two components: the one-component law along a line, and exact properties.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moat.hpp"
#include "planar_battery.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

BiaxialFrictionPendulum pendulum(const Friction& friction) {
  return {FrictionPendulum{.radius = 3 * m, .friction = friction, .weight = 1 * MN}};
}

// Along a line through the origin the force is that of the law of one component.
template <class Planar, class Line>
void expect_same_along_a_line(const Planar& planar, const Line& line, double move) {
  const double c = std::cos(0.7), s = std::sin(0.7), speed = 0.2;
  LawPath<Line> one{line, 0};
  PlanarPath<Planar> two{planar};
  RandomDraws draws{17};
  double largest = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double target = draws.uniform(-move, move), rate = std::copysign(speed, target - one.deformation());
    one.move(target, speed);
    const PlanVector force = two.to({c * target, s * target}, {c * rate, s * rate}).force;
    largest = std::max(largest, std::abs(one.force()));
    ASSERT_NEAR(force.x, c * one.force(), 1e-8 * largest) << i;
    ASSERT_NEAR(force.y, s * one.force(), 1e-8 * largest) << i;
  }
}

TEST(BiaxialFrictionPendulum, AlongALineIsThePendulum) {
  const BiaxialFrictionPendulum law = pendulum(0.06);
  expect_same_along_a_line(law, law.pendulum.carrying(law.pendulum.weight), 0.2);
}
TEST(BiaxialBilinear, AlongALineIsBilinear) {
  const Bilinear line{.yield_force = 215 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m};
  expect_same_along_a_line(BiaxialBilinear{line.yield_force, line.yield_displacement, line.post_yield_stiffness}, line,
                           0.03);
}

TEST(BiaxialGrantRubber, AlongALineIsTheRubber) {
  expect_same_along_a_line(BiaxialGrantRubber{GrantRubber::typical()}, GrantRubber::typical(), 0.09);
}

// A circle of 0.2 m at mu W = 60 kN with u_y = 1 mm: 2 pi R mu W sqrt(1 - (u_y/R)^2) per turn.
TEST(BiaxialFrictionPendulum, DissipatesOnACircleAsTheClosedFormSays) {
  const BiaxialFrictionPendulum law = pendulum(0.06);
  constexpr double radius = 0.2;
  constexpr int steps = 100000;
  PlanarPath<BiaxialFrictionPendulum> path{law};
  double at_start = 0.0;
  for (int i = 0; i <= 2 * steps; ++i) {
    if (i == steps) at_start = path.state.heat;
    const double angle = 2.0 * std::numbers::pi * i / steps;
    path.to({radius * std::cos(angle), radius * std::sin(angle)}, {1.0, 0.0});
  }
  EXPECT_NEAR((path.state.heat - at_start) / 1e3, 75.3973, 1e-3);
}

}  // namespace
}  // namespace moat::testing
