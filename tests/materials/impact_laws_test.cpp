#include "materials/impact_laws.hpp"

#include <gtest/gtest.h>

#include "impact_cases.hpp"
#include "law_battery.hpp"

namespace moat::testing {
namespace {

constexpr double mass = 5.5e5;

class EveryImpactLaw : public ::testing::TestWithParam<ImpactCase> {
 protected:
  // Calls the action with the law in its own form.
  template <class Action>
  void with_law(double restitution, Action action) const {
    std::visit(action, GetParam().between(1e9, restitution, mass).form());
  }
};

TEST_P(EveryImpactLaw, PassesTheBattery) {
  for (const double restitution : {1.0, 0.65, 0.45, 0.1, 0.02}) {
    if (restitution < GetParam().least) continue;
    SCOPED_TRACE(restitution);
    with_law(restitution, [&](const auto& law) {
      // The approach speed is 0.3 times the range; ViscousHertz has a corner at a hundred times that.
      expect_sound_contact(law, {.deformation = 0.05, .rate = 1.0, .rate_corners = {-30.0, 0.0, 30.0}},
                           GetParam().may_pull);
      expect_sound_contact(law, {.deformation = 1e-6, .rate = 1e-3, .rate_corners = {-0.03, 0.0, 0.03}},
                           GetParam().may_pull);
    });
  }
}

TEST_P(EveryImpactLaw, IsTheSameThroughAnyContact) {
  const AnyContact any = GetParam().between(1e9, 0.65, mass);
  expect_sound_contact(any, {.deformation = 0.05, .rate = 1.0, .rate_corners = {-30.0, 0.0, 30.0}},
                       GetParam().may_pull);
  with_law(0.65, [&](const auto& law) { EXPECT_EQ(any.contact_duration(mass, 0.3), law.contact_duration(mass, 0.3)); });
}

TEST_P(EveryImpactLaw, StaysFiniteWhereABodyOnlyGrazesOrLeans) {
  with_law(0.65, [&](const auto& law) {
    for (const double touch_speed : {0.0, 1e-300, 1e-12, 1e-4}) {
      const ContactState state = law.next_regime({}, 1e-13, touch_speed);
      EXPECT_EQ(state.phase, ContactPhase::loaded);
      for (const double d : {0.0, 5e-324, 1e-300, 1e-16, 1e-13, 1e-9, 1e-3, 1.0})
        for (const double v : {-1.0, -1e-9, 0.0, 1e-9, 1.0}) {
          ContactState trial;
          const Response response = law.evaluate(state, d, v, trial);
          EXPECT_TRUE(std::isfinite(response.force)) << d << " " << v;
          EXPECT_TRUE(std::isfinite(response.stiffness)) << d << " " << v;
          EXPECT_TRUE(std::isfinite(response.damping)) << d << " " << v;
          EXPECT_LE(std::abs(response.force), 200.0 * 1e9) << d << " " << v;
        }
    }
    EXPECT_GT(law.contact_duration(mass, least_approach_speed), 0.0);
    EXPECT_TRUE(std::isfinite(law.contact_duration(mass, least_approach_speed)));
  });
}

INSTANTIATE_TEST_SUITE_P(ImpactLaws, EveryImpactLaw, ::testing::ValuesIn(all_impact_laws()),
                         [](const auto& test) { return test.param.name; });

TEST(RootDampedHertz, HasExactTangentsBelowTheStraightLine) {
  const RootDampedHertz law{.stiffness = 1e9, .damping = 1e7};
  constexpr double least = RootDampedHertz::least_root_indentation;
  const ContactState loaded{ContactPhase::loaded, 0.3};
  expect_exact_tangents(law, loaded, {.deformation = 4.0 * least, .rate = 1.0, .deformation_corners = {0.0, least}});
  ContactState trial;
  const double below = law.evaluate(loaded, least * (1.0 - 1e-9), 1.0, trial).force;
  const double above = law.evaluate(loaded, least * (1.0 + 1e-9), 1.0, trial).force;
  EXPECT_NEAR(below, above, 1e-8 * above);
}

TEST(ContactState, FreezesTheApproachSpeedUntilTheGapOpens) {
  const ViscousHertz law{.stiffness = 1e9, .damping_factor = 1.0};
  const ContactState touched = law.next_regime({}, 1e-13, 0.5);
  EXPECT_EQ(touched.approach_speed, 0.5);
  // Drawn apart faster than v0/z the law ends, pushed together again it goes on with the same speed.
  const ContactState released = law.next_regime(touched, 1e-3, -0.6);
  EXPECT_EQ(released.phase, ContactPhase::released);
  const ContactState again = law.next_regime(released, 1e-3, 0.2);
  EXPECT_EQ(again.phase, ContactPhase::loaded);
  EXPECT_EQ(again.approach_speed, 0.5);
  EXPECT_EQ(law.next_regime(again, -1e-13, -0.2).phase, ContactPhase::open);
}

TEST(KelvinThatPulls, PullsBeforeTheGapOpensAndNotByDefault) {
  ContactState trial;
  const ContactState loaded{ContactPhase::loaded, 0.5};
  const Stiffness stiffness{1e9};
  const auto pulling = Kelvin{.stiffness = stiffness, .restitution = 0.65, .may_pull = true}.between(mass);
  EXPECT_LT(pulling.evaluate(loaded, 1e-6, -0.3, trial).force, 0.0);
  EXPECT_GT(pulling.regime_margin(loaded, 1e-6, -0.3), 0.0);
  const auto clamped = Kelvin{.stiffness = stiffness, .restitution = 0.65}.between(mass);
  EXPECT_LT(clamped.regime_margin(loaded, 1e-6, -0.3), 0.0);
}

}  // namespace
}  // namespace moat::testing
