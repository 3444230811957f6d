#include "materials/isolation/bouc_wen.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Q = 1 N and d_y = 1 m: z, and energies over Q d_y.
BoucWen bare(double exponent, double beta = 0.5) {
  return {.yield_force = 1 * N,
          .yield_displacement = 1 * m,
          .post_yield_stiffness = 0 * N / m,
          .exponent = exponent,
          .beta = beta};
}

struct Cycle {
  double z, energy;
};
// The steady cycle of an amplitude.
Cycle steady_cycle(const BoucWen& law, double amplitude) {
  LawPath<BoucWen> path{law, 0};
  path.move(amplitude, 1.0);
  for (int i = 0; i < 6; ++i) {
    path.move(-amplitude, 1.0);
    path.move(amplitude, 1.0);
  }
  const double before = path.dissipated();
  path.move(-amplitude, 1.0);
  path.move(amplitude, 1.0);
  return {path.state().z, path.dissipated() - before};
}

TEST(BoucWen, PassesTheBattery) {
  expect_sound_spring(BoucWen::typical(), {});
  for (const double exponent : {1.0, 1.5, 4.0})
    for (const double beta : {0.5, 0.9}) {
      BoucWen law = BoucWen::typical();
      law.exponent = exponent;
      law.beta = beta;
      law.hardening_stiffness = 30 * MN / m;
      law.hardening_displacement = 0.2 * m;
      SCOPED_TRACE(exponent);
      expect_sound_spring(law, {.deformation = 0.2, .moves = 12});
    }
}

TEST(BoucWen, HasTheSteadyCyclesOfTheClosedForms) {
  struct Case {
    double exponent, beta, amplitude, z, energy, digits;
  };
  for (const Case& each :
       {Case{1, 0.5, 2, 0.9525215090, 3.282616739, 1e-9}, Case{1, 0.5, 5, 0.9998766054, 15.000740352, 1e-9},
        Case{2, 0.5, 1.5, 0.9663307170, 1.781205060, 1e-9}, Case{2, 0.5, 2, 0.9951028346, 3.638173489, 1e-9},
        Case{2, 0.5, 10, 1, 35.613705639, 1e-9}, Case{2, 0.9, 2, 0.996588610, 4.25825, 5e-6},
        Case{50, 0.5, 2, 1, 3.998739, 1e-6}}) {
    const Cycle cycle = steady_cycle(bare(each.exponent, each.beta), each.amplitude);
    EXPECT_NEAR(cycle.z, each.z, 1e-9) << each.exponent << " " << each.amplitude;
    EXPECT_NEAR(cycle.energy, each.energy, each.digits) << each.exponent << " " << each.amplitude;
  }
}

TEST(BoucWen, AtRestItsTangentFollowsTheDirectionOfMotion) {
  const BoucWen law = bare(2);
  BoucWen::State trial;
  const BoucWen::State committed{0.3, 0.8, 0.0};
  EXPECT_DOUBLE_EQ(law.evaluate(committed, 0.3, 1.0, trial).stiffness, 1.0 - 0.64);
  EXPECT_DOUBLE_EQ(law.evaluate(committed, 0.3, -1.0, trial).stiffness, 1.0);
  EXPECT_EQ(trial, committed);
}

}  // namespace
}  // namespace moat::testing
