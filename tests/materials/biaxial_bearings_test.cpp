// Bearings of two components: the one-component law along a line, and exact properties.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "materials/plan/biaxial_friction_pendulum.hpp"
#include "materials/plan/biaxial_grant_rubber.hpp"
#include "message_of.hpp"
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

// Along a bent path whose speed changes; a fast one slides all the time.
TEST(BiaxialFrictionPendulum, KnowsTheRateOfItsForce) {
  const BiaxialFrictionPendulum law = pendulum(VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 5 * s / m});
  const auto d = [](double t) { return PlanVector{0.3 * t + 0.1 * t * t, 0.05 * std::sin(4.0 * t)}; };
  const auto v = [](double t) { return PlanVector{0.3 + 0.2 * t, 0.2 * std::cos(4.0 * t)}; };
  const auto a = [](double t) { return PlanVector{0.2, -0.8 * std::sin(4.0 * t)}; };
  BiaxialFrictionPendulum::State state;
  constexpr double h = 1e-4;
  PlanVector before, rate;
  double largest = 0.0, error = 0.0;
  for (int i = 1; i <= 5000; ++i) {
    const double t = i * h;
    BiaxialFrictionPendulum::State after;
    const PlanarResponse at = law.evaluate(state, d(t), v(t), h, after);
    state = after;
    const PlanVector now = at.force_rate + at.viscosity * a(t);
    if (i > 1000) {
      // The mean of both rates is that of the step.
      error = std::max(error, length((at.force - before) / h - 0.5 * (rate + now)));
      largest = std::max(largest, length(now));
    }
    before = at.force;
    rate = now;
  }
  EXPECT_LT(error, 1e-3 * largest);
}

TEST(BiaxialFrictionPendulum, NeedsTheWeightOnIt) {
  BiaxialFrictionPendulum law = pendulum(0.06);
  law.pendulum.weight = Force{};
  EXPECT_EQ(message_of([&] {
              law.check(Check{"PlanSpring", "bearing 1"});
            }),
            "PlanSpring \"bearing 1\": weight = 0 N is not allowed; it must be > 0 N and finite. Give the weight on "
            "this bearing; a PlanBuilding knows its share.");
}

}  // namespace
}  // namespace moat::testing
