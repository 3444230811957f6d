// The recipe "How to add an impact law" of CONTRIBUTING.md, compiled and held to the tests of all laws.

#include <gtest/gtest.h>

#include "expected_restitution.hpp"
#include "materials/impact/lee_wang.hpp"

namespace moat::testing {
#include "tests/expected_restitution_line.hpp"
}  // namespace moat::testing

#include "impact_cases.hpp"
#include "law_battery.hpp"
#include "materials/contact/free_impact.hpp"
#include "materials/contact/named_impact_law.hpp"

namespace moat::testing {
namespace {

TEST(ImpactLawRecipe, PassesTheTestsOfAllLaws) {
  const ImpactCase impact = impact_case<LeeWang>("", false, [](LeeWang&) {});
  for (const double restitution : {1.0, 0.65, 0.1}) {
    SCOPED_TRACE(restitution);
    ASSERT_TRUE(impact.accepts(restitution));
    const AnyContact law = impact.between(1e9, restitution, 5.5e5);
    expect_sound_contact(law, {.deformation = 0.05, .rate = 1.0, .rate_corners = {-30.0, 0.0, 30.0}}, false);
    EXPECT_NEAR(delivered_restitution(law, 5.5e5, 0.3), impact.delivered(1e9, restitution, 5.5e5, 0.3), 1e-8);
  }
  EXPECT_FALSE(impact.accepts(0.0));
}

TEST(ImpactLawRecipe, SaysWhatItIs) {
  const LeeWang law = impact_law<LeeWang>(2e9, 0.6);
  EXPECT_EQ(option_name(name_of(law)), "lee_wang");
  EXPECT_EQ(parameters_of(law)[1], (Parameter{"restitution", 0.6, "1"}));
}

}  // namespace
}  // namespace moat::testing
