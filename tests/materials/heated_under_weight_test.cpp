// A slider that heats on a line, under a weight that changes.
#include "materials/heated_under_weight.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "materials/carrying.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "random_draws.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;
static_assert(AxialForceLaw<HeatedUnderWeight> && LawWithRegimes<Carrying<HeatedUnderWeight>>);

HeatedUnderWeight pendulum() {
  HeatedUnderWeight law = HeatedFrictionPendulum::typical().under_changing_weight(2 * MN);
  law.line.friction.slider_radius = 5 * cm;
  law.line.friction.reference_pressure = 200 * MN / (m * m);
  return law;
}

TEST(HeatedUnderWeight, PassesTheBatteryUnderAConstantWeight) {
  const Carrying<HeatedUnderWeight> law{pendulum(), 1.5e6};
  const SpringTrial trial{.deformation = 0.15, .rate = 0.3, .pieces = 0.0, .one_speed = true, .moves = 100};
  expect_purity(law, trial);
  expect_symmetry(law, trial);
  expect_tangents(law, trial);
  expect_energy_balance_in_short_steps(
      law, {.deformation = 0.15, .rate = 0.3, .energy = 1e-3, .one_speed = true, .moves = 20});
}

TEST(HeatedUnderWeight, IsTheLawOfAConstantWeight) {
  const Carrying<HeatedUnderWeight> law{pendulum(), 2e6};
  LawPath<Carrying<HeatedUnderWeight>> path{law, 0};
  LawPath<HeatedSlidingIsolator> plain{law.law.line, 0};
  RandomMoves moves{{.deformation = 0.15, .rate = 0.3}};
  for (int i = 0; i < 200; ++i) {
    const double target = moves.target(path.deformation()), speed = moves.speed();
    path.move(target, speed, 5);
    plain.move(target, speed, 5);
    EXPECT_EQ(path.force(), plain.force()) << i;
    EXPECT_EQ(path.dissipated(), plain.dissipated()) << i;
  }
}

// Constant friction: mu 0.05, W 1 MN, u_y 1 mm, k_0 50 MN/m, without a restoring force.
HeatedUnderWeight constant_friction() {
  HeatedFrictionPendulum design{
      .radius = 1e9 * m,
      .friction = PressureTemperatureVelocity{.reference_coefficient = 0.05,
                                              .reference_pressure = 50 * MN / (m * m),
                                              .slider_radius = 20 * cm,
                                              .depends_on_pressure = false,
                                              .depends_on_speed = false,
                                              .weakening = PressureTemperatureVelocity::Weakening::none}};
  return design.under_changing_weight(1 * MN);
}

TEST(HeatedUnderWeight, ShedsItsFriction) {
  const HeatedUnderWeight law = constant_friction();
  HeatedUnderWeight::State state{.compression = 1e6}, next;
  double heat = 0.0, deformation = 0.0;
  const auto to = [&](double d, double rate, double weight) {
    EXPECT_GE(law.regime_margin(state, d, rate, {weight}), 0.0) << d;
    const Response response =
        law.evaluate(state, d, rate, {0.01, deformation, (d - deformation) / 0.01}, {weight}, next);
    heat += law.dissipated_energy(state, next);
    state = next;
    deformation = d;
    return response.force;
  };
  EXPECT_NEAR(to(0.8e-3, 0.1, 1e6), 40e3, 1.0);
  EXPECT_NEAR(law.stored_energy(state, deformation), 16.0, 1e-3);
  EXPECT_NEAR(to(0.8e-3, 0.0, 0.6e6), 30e3, 1.0);
  EXPECT_NEAR(state.slider.slip, 0.2e-3, 1e-12);
  EXPECT_NEAR(heat, 7.0, 1e-9);
  EXPECT_NEAR(law.stored_energy(state, deformation), 9.0, 1e-3);
  EXPECT_NEAR(to(0.8e-3, 0.0, 1e6), 30e3, 1.0);
  // It slides from 1.2 mm on.
  EXPECT_NEAR(to(1.2e-3, 0.1, 1e6), 50e3, 1.0);
  EXPECT_LT(law.regime_margin(state, 1.21e-3, 0.1, {1e6}), 0.0);
  state = law.next_regime(state, 1.2e-3, 0.1);
  EXPECT_EQ(state.slider.direction, 1);
  EXPECT_NEAR(to(2e-3, 0.1, 1e6), 50e3, 1.0);
  EXPECT_NEAR(state.slider.slip, 1.0e-3, 1e-12);
  EXPECT_NEAR(heat, 47.0, 1e-6);
}

// The limit falls while the deformation turns back late in the step: the slip is the largest o d - L/k_0.
TEST(HeatedUnderWeight, ShedsMostInsideTheStep) {
  const HeatedUnderWeight law = constant_friction();
  HeatedUnderWeight::State state{.compression = 1e6}, next;
  state.slider.friction_force = 50e3;  // d = 1 mm, on its limit
  // d = 1 mm - 2 mm x^2 and L = 50 - 50 x kN, of x = time over step: d - L/k_0 is largest at x = 1/4, 0.125 mm.
  const Response response = law.evaluate(state, -1e-3, -0.4, {0.01, 1e-3, 0.0}, {1e-3}, next);
  EXPECT_NEAR(next.slider.slip, 0.125e-3, 1e-11);
  EXPECT_LT(std::abs(response.force), 57e3);
}

// The rate of the force on a path of d and N against central differences of the force, sliding and shedding.
TEST(HeatedUnderWeight, KnowsTheRateOfItsForce) {
  const HeatedUnderWeight law = HeatedFrictionPendulum::typical().under_changing_weight(2 * MN);
  const double h = 1e-5, load_rate = -8e6;
  for (const int direction : {1, 0}) {
    HeatedUnderWeight::State state{.compression = 2e6}, next;
    const double d0 = 0.02, v0 = direction == 0 ? -1e-4 : 0.3, a0 = direction == 0 ? -0.01 : 2.0;
    if (direction == 1) {
      state = law.next_regime(state, d0, v0);
    } else {
      state.slider.friction_force = 1e6;  // beyond its limit at every weight below, so that it sheds
      state.slider.slip = d0 - state.slider.friction_force / law.line.elastic_stiffness;
    }
    ASSERT_EQ(state.slider.direction, direction);
    std::array<double, 5> force{};
    double rate_at_middle = 0.0;
    for (int i = 0; i < 5; ++i) {
      const double t = (i + 1) * h, from = t - h;
      const auto d = [&](double time) { return d0 + time * (v0 + 0.5 * time * a0); };
      const double v = v0 + a0 * t, weight = 2e6 + load_rate * t;
      force[static_cast<std::size_t>(i)] =
          law.evaluate(state, d(t), v, {h, d(from), v0 + a0 * from}, {weight, load_rate}, next).force;
      state = next;
      EXPECT_EQ(state.sheds, direction == 0 ? 1 : 0);
      if (i == 2) rate_at_middle = law.force_rate(state, d(t), v, a0, load_rate);
    }
    EXPECT_NEAR((force[3] - force[1]) / (2.0 * h), rate_at_middle, 2e-3 * std::abs(rate_at_middle)) << direction;
  }
}

TEST(HeatedUnderWeight, HasExactTangentsAndBalancesItsEnergy) {
  const HeatedUnderWeight law = pendulum();
  RandomDraws draws{53};
  HeatedUnderWeight::State state{.compression = 2e6}, next;
  double deformation = 0.0, rate = 0.2, force_before = 0.0, scale = 0.0;
  int sheds = 0, beside_corners = 0;
  for (int i = 0; i < 1000; ++i) {
    const double h = 0.01, v = rate + draws.uniform(-0.05, 0.05) - 0.1 * deformation - (i % 10 == 0 ? 2.0 * rate : 0.0),
                 d = deformation + 0.5 * h * (rate + v) * (i % 3 == 0 ? 0.05 : 1.0),
                 weight = draws.uniform(0.5, 3.0) * 1e6;
    const Interval interval{h, deformation, rate};
    const Response here = law.evaluate(state, d, v, interval, {weight}, next);
    sheds += state.slider.direction == 0 && next.slider.slip != state.slider.slip;
    const auto compare = [&](double move, double faster, double change, double tangent, double size) {
      HeatedUnderWeight::State ignored;
      const auto force = [&](double x) {
        return law.evaluate(state, d + x * move, v + x * faster, interval, {weight + x * change}, ignored).force;
      };
      const double central = 0.5 * (force(1.0) - force(-1.0));
      if (std::abs(force(1.0) - here.force - central) > 1e-3 * size)
        ++beside_corners;
      else
        EXPECT_NEAR(central, tangent, 1e-3 * size) << i;
    };
    compare(1e-8, 0.0, 0.0, 1e-8 * here.stiffness, 1e-8 * law.line.elastic_stiffness);
    compare(0.0, 1e-6, 0.0, 1e-6 * here.damping, 1e-6 * 1e5);
    compare(0.0, 0.0, 1.0, here.by_compression, 0.1);
    const double work = 0.5 * (force_before + here.force) * (d - deformation),
                 stored = law.stored_energy(next, d) - law.stored_energy(state, deformation),
                 of_weight = (weight - state.compression) * law.weight_lever(state, deformation, next, d);
    scale = std::max(scale, std::abs(work));
    EXPECT_NEAR(work, stored - of_weight + law.dissipated_energy(state, next), 1e-12 * scale) << i;
    state = next;
    force_before = here.force;
    deformation = d;
    rate = v;
    if (law.regime_margin(state, d, v, {weight}) < 0.0) {
      state = law.next_regime(state, d, v);
      force_before = law.evaluate(state, d, v, {0.0, d, v}, {weight}, next).force;
    }
  }
  EXPECT_GT(sheds, 5);
  EXPECT_LT(beside_corners, 100);
}

// After an event elsewhere the committed instant is evaluated again: force, tangents and rate are those of the step.
TEST(HeatedUnderWeight, ShedsAtAnInstantThatIsEvaluatedAgain) {
  const HeatedUnderWeight law = constant_friction();
  HeatedUnderWeight::State state{.compression = 1e6}, shed, again;
  constexpr double step = 0.01, deformation = 0.9e-3, falling = -2e7;  // s, m, N/s
  law.evaluate(state, deformation, 0.0, {step, 0.0, deformation / step}, {1e6}, shed);
  state = shed;
  ASSERT_EQ(state.slider.direction, 0) << "45 kN of 50 kN";
  const AxialForce axial{0.6e6};
  const Response first = law.evaluate(state, deformation, 0.0, {step, deformation, 0.0}, axial, shed);
  ASSERT_NE(shed.sheds, 0) << "45 kN of 30 kN";
  const Response second = law.evaluate(shed, deformation, 0.0, {0.0, deformation, 0.0}, axial, again);
  EXPECT_EQ(again.sheds, shed.sheds);
  EXPECT_NEAR(second.force, first.force, 1e-9 * std::abs(first.force));
  EXPECT_NEAR(second.stiffness, first.stiffness, 1e-9 * first.stiffness);
  const double rate = law.force_rate(shed, deformation, 0.0, 0.0, falling);
  EXPECT_NEAR(law.force_rate(again, deformation, 0.0, 0.0, falling), rate, 1e-6 * std::abs(rate));
  // A weight that grows makes it stick.
  law.evaluate(shed, deformation, 0.0, {0.0, deformation, 0.0}, {0.7e6}, again);
  EXPECT_EQ(again.sheds, 0);
}

}  // namespace
}  // namespace moat::testing
