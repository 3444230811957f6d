#include "materials/storeys/imk_bilinear.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

ImkBilinear lasting() {
  ImkBilinear law = ImkBilinear::typical();
  law.strength_capacity = law.stiffness_capacity = Length{};
  return law;
}

const std::vector<double> turns{0.02, -0.02, 0.03, -0.03, 0.06, -0.06, 0.06, -0.06};

TEST(ImkBilinear, PassesTheBattery) { expect_sound_spring(lasting(), {.deformation = 0.2}); }

TEST(ImkBilinear, FollowsTheBackboneWithoutDeterioration) {
  LawPath<ImkBilinear> path{lasting()};
  const std::vector<double> forces{2066.667, -2066.667, 2133.333, -2133.333, 1833.333, -1833.333, 1833.333, -1833.333};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    path.move(turns[i], 1.0);
    EXPECT_NEAR(path.force() / 1e3, forces[i], 1e-3) << i;
  }
}

TEST(ImkBilinear, DeterioratesAsAnIndependentProgram) {
  LawPath<ImkBilinear> path{ImkBilinear::typical()};
  const std::vector<double> forces{2066.667, -2033.655, 2065.750, -1995.330, 1679.618, -1527.508, 1389.213, -1254.942};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    path.move(turns[i], 1.0);
    EXPECT_NEAR(path.force() / 1e3, forces[i], 1e-3) << i;
    if (i == 0) {
      EXPECT_NEAR(path.state().work, 30.3333e3, 0.1);
    }
  }
  EXPECT_NEAR(path.state().work, 715.047e3, 1.0);
  EXPECT_NEAR(path.state().softened * 200.0, 88.607, 1e-3);
}

TEST(ImkBilinear, ReachesItsResidualForceAndFails) {
  LawPath<ImkBilinear> path{lasting()};
  path.move(0.138, 1.0);
  EXPECT_GT(path.force(), 0.4e6);
  // The cap line reaches it at 0.138182 m.
  path.move(0.1381815, 1.0);
  EXPECT_GT(path.force(), 0.4e6);
  path.move(0.1381825, 1.0);
  EXPECT_NEAR(path.force(), 0.4e6, 1e-3);
  path.move(0.249, 1.0);
  EXPECT_NEAR(path.force(), 0.4e6, 1e-3);
  path.move(0.251, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(-0.05, 1.0);
  EXPECT_EQ(path.force(), 0.0);
}

// At large drifts to one side the hardening line of the other lies below zero: no force until it has risen.
TEST(ImkBilinear, HasNoForceWhereTheHardeningLineIsBelowZero) {
  ImkBilinear law = lasting();
  law.cap_ratio = 1.5;
  law.residual_ratio = 0.0;
  law.ultimate_drift = 1 * m;
  // F_y/K_p = 6 cm: the line of the left side is below zero beyond +5 cm.
  LawPath<ImkBilinear> path{law, 0};
  path.move(0.5, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(0.06, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(-0.01, 1.0);
  EXPECT_NEAR(path.force(), -2e6, 1e-3);
  expect_sound_spring(law, {.deformation = 0.5, .gives_back = true, .moves = 100});
}

// Where the stiffness of unloading is used up it stays that of hardening, and the storey goes on.
TEST(ImkBilinear, DoesNotChatterWhereItsUnloadingIsAsSoftAsItsHardening) {
  ImkBilinear law = ImkBilinear::typical();
  law.strength_capacity = Length{};
  law.stiffness_capacity = 5 * m;
  law.stiffness_exponent = 0.3;
  law.ultimate_drift = 1 * m;
  LawPath<ImkBilinear> path{law, 0};
  for (int i = 0; i < 40; ++i) path.move(i % 2 == 0 ? 0.035 : -0.035, 1.0);
  EXPECT_GE(path.state().softened * law.stiffness.si(), 0.1 * 2e6 / 0.03 - 1e-3);
}

}  // namespace
}  // namespace moat::testing
