#include "materials/dampers/maxwell_damper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/units.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double pi = std::numbers::pi;

struct Cycle {
  double energy = 0.0, force = 0.0, storage = 0.0, loss = 0.0;
};
// The last of several cycles d = A sin(2 pi f t).
Cycle cycle(const MaxwellDamper& law, double frequency, double amplitude, double step) {
  MaxwellDamper::State state, trial;
  const auto steps = static_cast<int>(std::lround(1.0 / frequency / step));
  constexpr int cycles = 6;
  Cycle last;
  double before = 0.0;
  for (int i = 1; i <= cycles * steps; ++i) {
    const double phase = 2.0 * pi * i / steps, d = amplitude * std::sin(phase);
    const double length = 1.0 / frequency / steps;
    law.evaluate(state, d, 0.0, {length, before, 0.0}, trial);
    if (i > (cycles - 1) * steps) {
      const double work = 0.5 * (state.force + trial.force) * (d - before);
      last.energy += work;
      last.force = std::max(last.force, std::abs(trial.force));
      last.storage += trial.force * std::sin(phase) * 2.0 / steps / amplitude;
      last.loss += trial.force * std::cos(phase) * 2.0 / steps / amplitude;
    }
    state = trial;
    before = d;
  }
  return last;
}

TEST(MaxwellDamper, HasTheHarmonicResponseOfTheClosedForm) {
  const MaxwellDamper linear{.brace_stiffness = 50 * MN / m, .reference_force = 5 * MN, .exponent = 1.0};
  const Cycle linear_cycle = cycle(linear, 0.5, 0.1, 1e-4);
  EXPECT_NEAR(linear_cycle.force, 1498.584e3, 2e1);
  EXPECT_NEAR(linear_cycle.energy, 449.151e3, 5e0);
  EXPECT_NEAR(linear_cycle.storage, 4.491508e6, 1e2);
  EXPECT_NEAR(linear_cycle.loss, 14.296914e6, 1e2);
}

TEST(MaxwellDamper, ConvergesToTheHarmonicResponseWithAnExponent) {
  const MaxwellDamper stiff{.brace_stiffness = 100 * MN / m, .reference_force = 1.5 * MN, .exponent = 0.3};
  MaxwellDamper soft = stiff;
  soft.brace_stiffness = 25 * MN / m;
  EXPECT_NEAR(cycle(stiff, 0.4, 0.25, 1e-4).energy, 1181.22e3, 1e1);
  EXPECT_NEAR(cycle(stiff, 0.4, 0.25, 1e-4).force, 1304.756e3, 5e0);
  EXPECT_NEAR(cycle(soft, 0.4, 0.25, 1e-4).energy, 1087.09e3, 1e1);
  EXPECT_NEAR(cycle(soft, 0.4, 0.25, 1e-4).force, 1304.021e3, 5e0);
  // Of second order: 1181.113 kJ at 10 ms, 1181.194 at 5 ms.
  EXPECT_NEAR(cycle(stiff, 0.4, 0.25, 10e-3).energy, 1181.113e3, 20.0);
  EXPECT_NEAR(cycle(stiff, 0.4, 0.25, 5e-3).energy, 1181.194e3, 20.0);
}

TEST(MaxwellDamper, Relaxes) {
  const MaxwellDamper law{.brace_stiffness = 200 * MN / m, .reference_force = 2 * MN, .exponent = 0.35};
  MaxwellDamper::State state{.piston = -1.2e6 / 200e6, .force = 1.2e6}, trial;
  constexpr double step = 1e-5;
  for (int i = 1; i <= 20000; ++i) {
    law.evaluate(state, 0.0, 0.0, {step, 0.0, 0.0}, trial);
    state = trial;
    if (i == 1000) {
      EXPECT_NEAR(state.force, 896.3324e3, 1.0);
    }
    if (i == 5000) {
      EXPECT_NEAR(state.force, 527.8602e3, 1.0);
    }
    if (i == 20000) {
      EXPECT_NEAR(state.force, 275.4195e3, 1.0);
    }
  }
  EXPECT_NEAR(law.force_rate(state, 0.0, 0.0, 0.0), -200e6 * std::pow(275.4195e3 / 2e6, 1.0 / 0.35), 1e2);
}

TEST(MaxwellDamper, DoesNotRingWhereTheTrapezoidalRuleWould) {
  const MaxwellDamper law{.brace_stiffness = 10 * GN / m, .reference_force = 1 * MN, .exponent = 1.0};
  MaxwellDamper::State state{.force = 1e6}, trial;
  double before = state.force;
  for (int i = 0; i < 20; ++i) {
    law.evaluate(state, 0.0, 0.0, {0.01, 0.0, 0.0}, trial);
    state = trial;
    EXPECT_GE(state.force, 0.0);
    EXPECT_LT(state.force, before);
    before = state.force;
  }
}

}  // namespace
}  // namespace moat::testing
