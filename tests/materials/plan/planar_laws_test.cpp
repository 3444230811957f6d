// Duties of every law of two components. The tests of each law have its own properties.
#include "materials/plan/planar_laws.hpp"

#include <gtest/gtest.h>

#include <string>

#include "materials/contact/named_impact_law.hpp"
#include "message_of.hpp"
#include "planar_cases.hpp"

namespace moat::testing {
namespace {

TEST(EveryPlanarLaw, PassesTheBattery) {
  AllPlanarLaws::for_each([]<class Law>() {
    int count = 0;
    for (const PlanarCase<Law>& each : planar_cases<Law>()) {
      SCOPED_TRACE(std::string{Law::name} + " " + std::to_string(++count));
      EXPECT_EQ(message_of([&] { each.law.check(Check{"PlanSpring", "bearing"}); }), "nothing was thrown");
      expect_sound_planar_law(each.law, each.trial);
    }
    EXPECT_GT(count, 0) << Law::name;
  });
}

// A design becomes a law in plan: its own parameters are checked before.
TEST(DesignsInPlan, RefuseBadParameters) {
  using namespace units;
  const FlatSlider rigid{.friction = 0.05, .yield_displacement = 0 * mm};
  EXPECT_TRUE(message_of([&] { in_plan(rigid, 1 * MN); }).starts_with("FlatSlider: yield_displacement = 0 m"));
  EXPECT_TRUE(message_of([&] { in_plan_under_changing_weight(rigid, 1 * MN); }).starts_with("FlatSlider: yield"));
  const FrictionPendulum flat{.radius = 0 * m, .friction = 0.05};
  EXPECT_TRUE(message_of([&] { in_plan_under_changing_weight(flat, 1 * MN); }).starts_with("FrictionPendulum: radius"));
  DoublePendulum two = DoublePendulum::typical();
  two.first_radius = -1 * m;
  EXPECT_TRUE(message_of([&] { in_plan(two, 1 * MN); }).starts_with("DoublePendulum: first_radius = -1 m"));
}

}  // namespace
}  // namespace moat::testing
