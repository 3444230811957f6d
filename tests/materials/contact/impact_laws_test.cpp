#include "materials/contact/impact_laws.hpp"

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
    if (!GetParam().accepts(restitution)) continue;
    SCOPED_TRACE(restitution);
    with_law(restitution, [&](const auto& law) {
      // The approach speed is 0.3 times the range; ViscousHertzContact has a corner at a hundred times that.
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

INSTANTIATE_TEST_SUITE_P(ImpactLaws, EveryImpactLaw, ::testing::ValuesIn(all_impact_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(RootDampedHertzContact, HasExactTangentsBelowTheStraightLine) {
  const RootDampedHertzContact law{.stiffness = 1e9, .damping = 1e7};
  constexpr double least = RootDampedHertzContact::least_root_indentation;
  const ContactState loaded{ContactPhase::loaded, 0.3};
  expect_exact_tangents(law, loaded, {.deformation = 4.0 * least, .rate = 1.0, .deformation_corners = {0.0, least}});
  ContactState trial;
  const double below = law.evaluate(loaded, least * (1.0 - 1e-9), 1.0, trial).force;
  const double above = law.evaluate(loaded, least * (1.0 + 1e-9), 1.0, trial).force;
  EXPECT_NEAR(below, above, 1e-8 * above);
}

// A released contact has no force, and its stored energy becomes heat while the gap opens.
TEST(ViscousLinearContact, LosesWhatItStoresOnceItIsReleased) {
  const ViscousLinearContact law{.stiffness = 1e9, .damping = {2e7}};
  const ContactState released{ContactPhase::released, 0.3};
  for (const double d : {1e-4, 0.02})
    for (const double v : {-0.5, -1e-3}) {
      constexpr double h = 1e-6;
      const double stored = law.stored_energy(released, d - v * h) - law.stored_energy(released, d + v * h);
      EXPECT_NEAR(law.dissipation_rate(released, d, v), stored / (2.0 * h), 1e-6 * stored / h) << d << ", " << v;
    }
  EXPECT_EQ(law.dissipation_rate(released, 0.02, 0.1), 0.0) << "heat does not come back";
}

// A margin is a length: in other units of length it is another number, and the same length. m = `unit` new units.
template <class Contact>
void expect_margin_is_a_length(const Contact& in_metres, const Contact& in_new_units, double unit) {
  for (const ContactPhase phase : {ContactPhase::open, ContactPhase::loaded, ContactPhase::released})
    for (const double d : {-1e-3, 2e-4, 0.05})
      for (const double v : {-0.6, -0.2, 0.4}) {
        const double margin = in_metres.regime_margin({phase, 0.3}, d, v);
        const double same = in_new_units.regime_margin({phase, 0.3 * unit}, d * unit, v * unit);
        EXPECT_NEAR(same, margin * unit, 2e-12 + 2.0 * unit * reload_threshold) << d << " m, " << v << " m/s";
      }
}

TEST(RegimeMargin, OfEveryContactIsALength) {
  const double unit = 1000.0;  // millimetres
  expect_margin_is_a_length(ViscousLinearContact{1e9, 2e7}, ViscousLinearContact{1e9, 2e7}, unit);
  // k in N/mm^1.5 and c in N s/mm^1.25, with N for N.
  const double k = 1e9 * std::pow(unit, -1.5), c = 2e7 * std::pow(unit, -1.25);
  expect_margin_is_a_length(ViscousHertzContact{1e9, 0.8}, ViscousHertzContact{k, 0.8}, unit);
  expect_margin_is_a_length(RootDampedHertzContact{1e9, 2e7}, RootDampedHertzContact{k, c}, unit);
}

}  // namespace
}  // namespace moat::testing
