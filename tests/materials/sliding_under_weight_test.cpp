// Sliders under a weight that changes: stick, shedding, slide and lift; on a line and in plan.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double weight = 1e6;  // N

const Friction of_ptfe = VelocityPressureDependent{.slow = 0.03,
                                                   .at_zero_pressure = 0.10,
                                                   .reduction = 0.05,
                                                   .pressure_factor = 2.5e-8 * m * m / N,
                                                   .area = 0.04 * m * m,
                                                   .rate = 50 * s / m};

SlidingUnderWeight flat(double mu = 0.05) {
  return FlatSlider{.friction = mu, .yield_displacement = 1 * mm}.under_changing_weight(weight * N);
}
FrictionPendulum pendulum(const Friction& friction, Length radius = 2 * m, Length reach = 1 * mm) {
  return {.radius = radius, .friction = friction, .yield_displacement = reach};
}

TEST(SlidingUnderWeight, ShedsForceWhileItSticksAndKeepsTheRest) {
  const SlidingUnderWeight law = flat();
  SlidingUnderWeight::State before, after;
  const auto go = [&](double to, double rate, double compression) {
    const double from = after.slip + after.friction_force / law.elastic_stiffness;
    before = after;
    law.evaluate(before, to, rate, {1.0, from, rate}, {compression, 0.0}, after);
  };
  go(0.0, 0.0, weight);
  go(0.8e-3, 1e-3, weight);
  EXPECT_NEAR(after.friction_force, 40e3, 1e-9);
  EXPECT_NEAR(law.stored_energy(after, 0.8e-3), 16.0, 1e-12);
  go(0.8e-3, 0.0, 0.6 * weight);
  EXPECT_NEAR(after.friction_force, 30e3, 1e-9);
  EXPECT_NEAR(after.slip, 0.2e-3, 1e-15);
  EXPECT_NEAR(law.dissipated_energy(before, after), 7.0, 1e-9);
  EXPECT_NEAR(law.stored_energy(after, 0.8e-3), 9.0, 1e-9);
  go(0.8e-3, 0.0, weight);
  EXPECT_NEAR(after.friction_force, 30e3, 1e-9);
  // It slides from d = 1.2 mm on, and has slipped by 1 mm at 2 mm: 47 J in all.
  EXPECT_GT(law.regime_margin(after, 0.8e-3, 1e-3), 0.0);
  go(1.2e-3, 1e-3, weight);
  EXPECT_NEAR(law.regime_margin(after, 1.2e-3, 1e-3), 0.0, 2e-12);
  after = law.next_regime(after, 1.2e-3, 1e-3);
  go(2e-3, 1e-3, weight);
  EXPECT_NEAR(after.friction_force, 50e3, 1e-9);
  EXPECT_NEAR(after.slip, 1e-3, 1e-15);
  EXPECT_NEAR(7.0 + law.dissipated_energy(before, after), 47.0, 1e-9);
}

// N(t) falls and rises again inside the step; the slip is that of the lowest N.
TEST(SlidingUnderWeight, ShedsWhatTheLowestWeightOfAStepAsks) {
  const SlidingUnderWeight law = flat();
  SlidingUnderWeight::State start, stuck, after;
  law.evaluate(start, 0.8e-3, 1e-3, {}, {weight, 0.0}, stuck);
  // N = W (1 - 2 x + 2 x^2) for x from 0 to 1 s: 0.5 W in the middle.
  law.evaluate(stuck, 0.8e-3, 0.0, {1.0, 0.8e-3, 0.0}, {weight, -2.0 * weight}, after);
  EXPECT_NEAR(after.friction_force, 25e3, 1e-6);
  EXPECT_EQ(after.sheds, 0);
}

TEST(SlidingUnderWeight, LiftsAndLandsWithoutAForce) {
  const SlidingUnderWeight law = flat();
  SlidingUnderWeight::State state, after;
  law.evaluate(state, 0.5e-3, 1e-3, {}, {weight, 0.0}, state);
  law.evaluate(state, 0.6e-3, 1e-3, {1.0, 0.5e-3, 1e-3}, {-0.1 * weight, -weight}, after);
  EXPECT_LT(law.regime_margin(after, 0.6e-3, 1e-3), 0.0);
  const SlidingUnderWeight::State lifted = law.next_regime(after, 0.6e-3, 1e-3);
  EXPECT_EQ(lifted.contact, SlidingUnderWeight::Contact::lifted);
  EXPECT_EQ(law.evaluate(lifted, 0.3, 1.0, {0.3, 0.0, 1.0}, {-0.2 * weight, 0.0}, after).force, 0.0);
  EXPECT_EQ(after.slip, 0.3);
  after.compression = 1e-9;
  const SlidingUnderWeight::State landed = law.next_regime(after, 0.3, -1.0);
  EXPECT_EQ(landed.contact, SlidingUnderWeight::Contact::slides_back);
}

// Under a constant weight it is today's law: the same regimes, to the last digits.
TEST(SlidingUnderWeight, UnderAConstantWeightIsTheSlider) {
  for (const Friction& friction : {Friction{0.06}, of_ptfe}) {
    const FrictionPendulum design = pendulum(friction);
    const SlidingIsolator constant = design.carrying(weight * N);
    const SlidingUnderWeight changing = design.under_changing_weight(weight * N);
    SlidingIsolator::State a, a1;
    SlidingUnderWeight::State b, b1;
    double d = 0.0;
    for (int i = 1; i < 20000; ++i) {
      const double t = 1e-3 * i, to = 0.01 * std::sin(t) + 0.004 * std::sin(2.7 * t),
                   rate = 0.01 * std::cos(t) + 0.0108 * std::cos(2.7 * t);
      const Response one = constant.evaluate(a, to, rate, a1);
      const Response two = changing.evaluate(b, to, rate, {1e-3, d, rate}, {weight, 0.0}, b1);
      ASSERT_NEAR(two.force, one.force, 1e-12 * weight) << i;
      ASSERT_EQ(two.stiffness, one.stiffness);
      ASSERT_EQ(two.damping, one.damping);
      ASSERT_NEAR(changing.stored_energy(b1, to), constant.stored_energy(a1, to), 1e-9);
      a = a1;
      b = b1;
      d = to;
      while (constant.regime_margin(a, d, rate) < 0.0) a = constant.next_regime(a, d, rate);
      while (changing.regime_margin(b, d, rate) < 0.0) b = changing.next_regime(b, d, rate);
      ASSERT_EQ(a.direction, b.direction()) << i;
    }
  }
}

// dF/dd, dF/dv and dF/dN against differences, in every regime.
TEST(SlidingUnderWeight, TangentsAreThoseOfItsForce) {
  const SlidingUnderWeight law = pendulum(of_ptfe).under_changing_weight(weight * N);
  using Contact = SlidingUnderWeight::Contact;
  const double k0 = law.elastic_stiffness;
  for (const auto& [contact, d, rate, compression] : {std::tuple{Contact::sticks, 0.1002, 0.02, 0.9 * weight},
                                                      {Contact::sticks, 0.1004, -0.02, 0.2 * weight},
                                                      {Contact::slides_on, 0.1, 0.03, 1.2 * weight},
                                                      {Contact::slides_back, 0.1, -0.03, 0.8 * weight},
                                                      {Contact::lifted, 0.1, 0.03, -0.1 * weight}}) {
    SlidingUnderWeight::State committed{.slip = 0.1 - 0.5 * 0.03 * weight / k0,
                                        .friction_force = 0.5 * 0.03 * weight,
                                        .compression = weight,
                                        .contact = contact};
    const auto force = [&](double dd, double dv, double dn) {
      SlidingUnderWeight::State trial;
      return law.evaluate(committed, d + dd, rate + dv, {}, {compression + dn, 0.0}, trial);
    };
    const Response response = force(0.0, 0.0, 0.0);
    EXPECT_NEAR((force(1e-7, 0, 0).force - force(-1e-7, 0, 0).force) / 2e-7, response.stiffness, 1e-5 * k0);
    EXPECT_NEAR((force(0, 1e-5, 0).force - force(0, -1e-5, 0).force) / 2e-5, response.damping, 1e-4 * weight);
    EXPECT_NEAR((force(0, 0, 10).force - force(0, 0, -10).force) / 20.0, response.by_compression, 1e-8);
  }
}

TEST(PlanarSliderUnderWeight, DerivativeByTheWeightIsThatOfItsForce) {
  const PlanarSliderUnderWeight law = in_plan_under_changing_weight(pendulum(of_ptfe), weight * N);
  for (const PlanVector increment : {PlanVector{0.2e-3, 0.1e-3}, PlanVector{5e-3, -3e-3}}) {
    for (const double compression : {0.7 * weight, 1.3 * weight}) {
      const PlanarSliderUnderWeight::State committed{.friction_force = {0.02 * weight, 0.015 * weight},
                                                     .deformation = {0.05, 0.08},
                                                     .rate = {0.1, 0.3},
                                                     .compression = weight};
      const auto response = [&](double dn) {
        PlanarSliderUnderWeight::State trial;
        return law.evaluate(committed, committed.deformation + increment, {0.2, 0.25}, 0.01, {compression + dn, 0.0},
                            trial);
      };
      const PlanVector slope = (response(5.0).force - response(-5.0).force) / 10.0;
      EXPECT_NEAR(response(0.0).by_compression.x, slope.x, 1e-7);
      EXPECT_NEAR(response(0.0).by_compression.y, slope.y, 1e-7);
    }
  }
}

// d = 0.2 m sin t under N = W (1 + 0.4 cos 2t) and W (1 + 0.4 sin 2t), nearly rigid-plastic.
TEST(PlanarSliderUnderWeight, HeatAndWorkOfTheWeightHaveTheirClosedForms) {
  const PlanarSliderUnderWeight law = in_plan_under_changing_weight(pendulum(0.05, 2 * m, 1e-4 * mm), weight * N);
  constexpr int steps = 200000;
  for (const bool in_phase : {true, false}) {
    PlanarSliderUnderWeight::State state, after;
    double heat = 0.0, weight_work = 0.0, restoring = 0.0;
    for (int i = 0; i <= 2 * steps; ++i) {
      const double t = 2.0 * std::numbers::pi * i / steps;
      const double n = weight * (1.0 + 0.4 * (in_phase ? std::cos(2 * t) : std::sin(2 * t))), d = 0.2 * std::sin(t);
      law.evaluate(state, {d, 0.0}, {0.2 * std::cos(t), 0.0}, 0.0, {n, 0.0}, after);
      if (i > steps) {
        heat += law.dissipated_energy(state, after);
        weight_work += (n - state.compression) * law.weight_lever(state, state.deformation, after, {d, 0.0});
        restoring += 0.5 * (state.compression * state.deformation.x + n * d) / 2.0 * (d - state.deformation.x);
      }
      state = after;
    }
    EXPECT_NEAR(heat / 1e3, in_phase ? 45.333333 : 40.0, 1e-3);
    EXPECT_NEAR(weight_work / 1e3, in_phase ? 0.0 : -12.566371, 1e-4);
    EXPECT_NEAR(restoring / 1e3, in_phase ? 0.0 : 12.566371, 1e-4);
  }
}

}  // namespace
}  // namespace moat::testing
