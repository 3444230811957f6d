// Laws with a changed stiffness and restitution.

#include "materials/contact/changed_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "impact_cases.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

TEST(ChangedLaw, OfMoatHasItsStiffnessAndRestitutionChangedAndNothingElse) {
  AllImpactLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    const Law law = impact_law<Law>(1e9, 0.65);
    ASSERT_TRUE(has_stiffness(law));
    const std::vector<Parameter> before = law.parameters(), stiffer = with_stiffness_factor(law, 3.0).parameters(),
                                 softer = with_restitution_change(law, -0.1).parameters();
    ASSERT_EQ(stiffer.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(stiffer[i].value, (before[i].name == "stiffness" ? 3.0 : 1.0) * before[i].value) << before[i].name;
      if (before[i].name == "damping_ratio") continue;
      EXPECT_NEAR(softer[i].value, before[i].value - (before[i].name == "restitution" ? 0.1 : 0.0), 1e-15)
          << before[i].name;
    }
    EXPECT_EQ(with_restitution_change(with_stiffness_factor(law, 1.0), 0.0).parameters(), before);
    const bool elastic =
        parameter_of(before, "restitution", -1.0) < 0.0 && parameter_of(before, "damping_ratio", -1.0) < 0.0;
    EXPECT_EQ(restitution_of_law(law).has_value(), !elastic);
  });
}

TEST(ChangedLaw, GivenByADampingRatioDeliversTheChangedRestitution) {
  constexpr double mass = 2e5, speed = 0.4;  // kg, m/s
  for (const bool pulls : {false, true}) {
    const KelvinByDampingRatio law{.stiffness = 1e9 * N / m, .damping_ratio = 0.14, .may_pull = pulls};
    const double before = delivered_restitution(law.between(mass), mass, speed);
    EXPECT_NEAR(*restitution_of_law(law), before, 1e-8);
    for (const double change : {-0.1, 0.1})
      EXPECT_NEAR(delivered_restitution(with_restitution_change(law, change).between(mass), mass, speed),
                  before + change, 1e-8);
  }
}

TEST(ChangedLaw, KeepsTheRestitutionInItsRange) {
  EXPECT_EQ(changed_restitution(0.95, 0.1), 1.0);
  EXPECT_EQ(changed_restitution(0.05, -0.1), 1e-3);
  EXPECT_EQ(changed_restitution(5e-4, -0.1), 5e-4) << "a law that allows it keeps it";
  EXPECT_NEAR(changed_restitution(0.65, 0.1), 0.75, 1e-15);
}

TEST(ChangedLaw, KeepsTheSpeedsOfARestitutionThatFalls) {
  const ExactHertzDamp falling{.stiffness = 1e10 * N / m_3_2,
                               .restitution = FallingRestitution{.restitution = 0.6, .largest = 0.85}};
  const Restitution raised = with_restitution_change(falling, 0.1).restitution;
  EXPECT_NEAR(raised.at(0.3), 0.7, 1e-15);
  EXPECT_NEAR(raised.at(1.0), 0.7 * std::pow(1.0 / 0.3, -0.25), 1e-15);
  EXPECT_NEAR(raised.at(1e-3), 0.95, 1e-15);
  EXPECT_NEAR(*restitution_of_law(falling), 0.6 * std::pow(1.0 / 0.3, -0.25), 1e-15) << "at 1 m/s";
  const ExactHertzDamp measured{.stiffness = 1e10 * N / m_3_2,
                                .restitution = MeasuredRestitution{{{0.1 * m / s, 0.95}, {1 * m / s, 0.55}}}};
  const Restitution above = with_restitution_change(measured, 0.1).restitution;
  EXPECT_EQ(above.at(0.1), 1.0);
  EXPECT_NEAR(above.at(1.0), 0.65, 1e-15);
}

TEST(ChangedLaw, ChosenByNameHasARestitutionOnlyWhereItsLawHas) {
  const auto named = [](const char* name) {
    return NamedImpactLaw{
        .name = name, .linear_stiffness = 5.8e8 * N / m, .hertz_stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};
  };
  EXPECT_FALSE(restitution_of_law(named("hertz")).has_value());
  EXPECT_EQ(restitution_of_law(named("hertz_damp")), 0.65);
  EXPECT_EQ(parameter_of(with_stiffness_factor(named("hertz"), 2.0).parameters(), "stiffness", -1.0), 5.9e9);
  EXPECT_EQ(parameter_of(with_stiffness_factor(named("kelvin"), 2.0).parameters(), "stiffness", -1.0), 1.16e9);
  EXPECT_NEAR(parameter_of(with_restitution_change(named("kelvin"), 0.1).parameters(), "restitution", -1.0), 0.75,
              1e-15);
}

// Laws of a script: plain numbers, quantities, and neither.
struct PlainLaw {
  double stiffness = 1e9, restitution = 0.5;
};
struct LawWithUnits {
  Required<HertzStiffness> stiffness;
};
struct OtherLaw {
  double crushing_force = 1e6;
};

TEST(ChangedLaw, OfAScriptTakesPartByItsFields) {
  EXPECT_EQ(with_stiffness_factor(PlainLaw{}, 3.0).stiffness, 3e9);
  EXPECT_EQ(with_restitution_change(PlainLaw{}, 0.25).restitution, 0.75);
  const LawWithUnits hertz{.stiffness = 2e9 * N / m_3_2};
  EXPECT_EQ(with_stiffness_factor(hertz, 0.5).stiffness.si(), 1e9);
  EXPECT_FALSE(restitution_of_law(hertz).has_value());
  EXPECT_FALSE(has_stiffness(OtherLaw{}));
  EXPECT_FALSE(restitution_of_law(OtherLaw{}).has_value());
  EXPECT_EQ(with_restitution_change(with_stiffness_factor(OtherLaw{}, 3.0), 0.1).crushing_force, 1e6);
}

}  // namespace
}  // namespace moat::testing
