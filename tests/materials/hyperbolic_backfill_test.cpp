#include "materials/soil/hyperbolic_backfill.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Per metre of width.
const HyperbolicBackfill per_metre{.initial_stiffness = 20.3 * MN / m, .ultimate_force = 326 * kN};

TEST(HyperbolicBackfill, PassesTheBattery) {
  expect_sound_spring(HyperbolicBackfill::typical(), {.deformation = 0.1, .symmetric = false, .one_sided = true});
  HyperbolicBackfill stiffer = HyperbolicBackfill::typical();
  stiffer.unloading_stiffness = 500 * MN / m;
  expect_sound_spring(stiffer, {.deformation = 0.1, .symmetric = false, .one_sided = true});
}

TEST(HyperbolicBackfill, HasTheForcesOfTheHyperbola) {
  LawPath<HyperbolicBackfill> path{per_metre};
  path.move(0.01, 1.0);
  EXPECT_NEAR(path.force(), 141.3758e3, 0.1);
  path.move(0.05, 1.0);
  EXPECT_NEAR(path.force(), 319.2378e3, 0.1);
  path.move(0.1, 1.0);
  EXPECT_NEAR(path.force(), 378.8094e3, 0.1);
  path.move(1e6, 1.0);
  EXPECT_NEAR(path.force(), 465.714e3, 1.0);
}

TEST(HyperbolicBackfill, LeavesAGapAndItsHeat) {
  LawPath<HyperbolicBackfill> path{per_metre};
  path.move(0.05, 1.0);
  EXPECT_NEAR(path.work(), 10.927189e3, 1e-2);
  EXPECT_NEAR(path.stored(), 2.510167e3, 1e-2);
  path.move(0.0, 1.0);
  EXPECT_NEAR(path.dissipated(), 8.417022e3, 1e-2);
  EXPECT_NEAR(per_metre.quantity(0, path.state(), 0.0, 0.0, 0.0).value, 34.274e-3, 1e-6);
  EXPECT_EQ(path.force(), 0.0);
  path.move(0.034, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(0.05, 1.0);
  EXPECT_NEAR(path.force(), 319.2378e3, 0.1);
}

// Shamsabadi's form F = C y/(1 + D y).
TEST(HyperbolicBackfill, IsTheFormOfShamsabadi) {
  constexpr double c = 4.5e7, d = 20.0;
  const HyperbolicBackfill law{.initial_stiffness = c * N / m, .ultimate_force = 0.9 * c / d * N, .failure_ratio = 0.9};
  LawPath<HyperbolicBackfill> path{law};
  path.move(0.025, 1.0);
  EXPECT_NEAR(path.force(), 0.75e6, 1e-3);
}

}  // namespace
}  // namespace moat::testing
