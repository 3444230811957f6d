#include "materials/isolation/kikuchi_aiken_rubber.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Force is stress, deformation is strain.
const KikuchiAikenRubber unit{.area = 1 * m * m, .height = 1 * m};

TEST(KikuchiAikenRubber, PassesTheBattery) {
  for (const auto compound : {KikuchiAikenRubber::Compound::x06, KikuchiAikenRubber::Compound::x04})
    for (const double strain : {0.04, 1.0, 2.5}) {
      const KikuchiAikenRubber law{.area = 1 * m * m, .height = 1 * m, .compound = compound};
      const SpringTrial trial{.deformation = strain, .pieces = 1e-7, .moves = 200};
      SCOPED_TRACE(strain);
      expect_tangents(law, trial);
      expect_purity(law, trial);
      expect_symmetry(law, trial);
      expect_independence_of_pieces(law, trial);
    }
}

TEST(KikuchiAikenRubber, HasThePropertiesOfTheCompound) {
  EXPECT_NEAR(unit.of_rubber().shear_modulus(1.0), 0.68358e6, 1e-3);
  EXPECT_NEAR(unit.of_rubber().damping_ratio(1.0), 0.21031966, 1e-8);
  EXPECT_NEAR(unit.of_rubber().hysteretic_share(1.0), 0.37565990, 1e-8);
  EXPECT_NEAR(unit.of_rubber().decay(1.0), 8.29444384, 1e-7);
}

TEST(KikuchiAikenRubber, FollowsTheSkeleton) {
  LawPath<KikuchiAikenRubber> path{unit, 0};
  for (const auto& [strain, stress] :
       {std::pair{1.5, 0.889504e6}, std::pair{2.0, 1.132924e6}, std::pair{3.0, 1.883169e6}}) {
    path.move(strain, 1.0);
    EXPECT_NEAR(path.force(), stress, 1.0) << strain;
  }
}

// The damping of the compound goes in and comes out.
TEST(KikuchiAikenRubber, HasTheLoopOfItsDampingRatio) {
  LawPath<KikuchiAikenRubber> path{unit, 0};
  path.move(1.0, 1.0);
  path.move(-1.0, 1.0);
  path.move(1.0, 1.0);
  const double before = path.dissipated();
  path.move(-1.0, 1.0);
  path.move(1.0, 1.0);
  EXPECT_NEAR((path.dissipated() - before) / 0.68358e6, 1.32147742, 1e-5);
  EXPECT_NEAR(1.32147742, 2.0 * std::numbers::pi * unit.of_rubber().damping_ratio(1.0), 1e-7);
}

TEST(KikuchiAikenRubber, ClosesInnerLoops) {
  LawPath<KikuchiAikenRubber> path{unit, 0};
  path.move(1.0, 1.0);
  path.move(-0.2, 1.0);
  const double outer = path.force();
  path.move(0.3, 1.0);
  const double inner = path.force();
  path.move(0.1, 1.0);
  path.move(0.3, 1.0);
  EXPECT_NEAR(path.force(), inner, 1e-6 * std::abs(inner));
  path.move(-0.2, 1.0);
  EXPECT_NEAR(path.force(), outer, 1e-6 * std::abs(outer));
}

}  // namespace
}  // namespace moat::testing
