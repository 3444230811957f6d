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

}  // namespace
}  // namespace moat::testing
