#include "materials/storeys/imk_bilinear.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"
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

TEST(ImkBilinear, PassesTheBattery) {
  expect_sound_spring(lasting(), {.deformation = 0.2});
  ImkBilinear slowly = ImkBilinear::typical();
  slowly.strength_capacity = slowly.stiffness_capacity = 60 * m;
  const SpringTrial trial{.deformation = 0.1, .moves = 100};
  expect_tangents(slowly, trial);
  expect_purity(slowly, trial);
  expect_independence_of_pieces(slowly, trial);
  expect_symmetry(slowly, trial);
}

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
  path.move(0.1382, 1.0);
  EXPECT_NEAR(path.force(), 0.4e6, 1e-3);
  path.move(0.249, 1.0);
  EXPECT_NEAR(path.force(), 0.4e6, 1e-3);
  path.move(0.251, 1.0);
  EXPECT_EQ(path.force(), 0.0);
  path.move(-0.05, 1.0);
  EXPECT_EQ(path.force(), 0.0);
}

TEST(ImkBilinear, RefusesAFailureBeforeItYields) {
  ImkBilinear law = ImkBilinear::typical();
  law.ultimate_drift = 5 * mm;
  EXPECT_EQ(
      message_of([&] {
        law.check(Check{"Storey", "storey 1"});
      }),
      "Storey \"storey 1\": ultimate_drift = 0.005 m is not allowed; it must be above the yield drift yield_force / "
      "stiffness = 0.01 m.");
}

}  // namespace
}  // namespace moat::testing
