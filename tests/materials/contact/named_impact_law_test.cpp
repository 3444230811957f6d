#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>

#include "impact_cases.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Check check{"Gap", "moat left"};
constexpr double mass = 5.5e5;

NamedImpactLaw named(const std::string& name) {
  return {.name = name, .linear_stiffness = 5.8e8 * N / m, .hertz_stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};
}

// Force of the law while it is loaded.
template <class Law>
double force_of(const Law& law, double indentation, double rate) {
  ContactState trial;
  return law.evaluate({ContactPhase::loaded, 0.3}, indentation, rate, trial).force;
}

TEST(NamedImpactLaw, IsTheLawOfThatName) {
  std::size_t names = 0;
  const auto expect_same = [&](std::string_view type, const auto& law) {
    SCOPED_TRACE(type);
    const NamedImpactLaw by_name = named(option_name(type));
    for (const double rate : {-0.2, 0.25})
      EXPECT_EQ(force_of(by_name.between(mass), 0.01, rate), force_of(law.between(mass), 0.01, rate));
    EXPECT_EQ(name_of(by_name), name_of(law));
    EXPECT_EQ(parameters_of(by_name), parameters_of(law));
    ++names;
  };
  AllImpactLaws::for_each([&]<class Law>() {
    // Those that a stiffness and a restitution describe.
    if constexpr (
        !requires(Law law) { law.damping_ratio; } && !requires(Law law) { law.expected_indentation; }) {
      const bool linear = std::same_as<StiffnessOf<Law>, Stiffness>;
      const Law law = impact_law<Law>(linear ? 5.8e8 : 2.95e9, 0.65);
      expect_same(Law::name, law);
      if (!alias_of<Law>().empty()) expect_same(alias_of<Law>(), law);
    }
  });
  EXPECT_EQ(impact_law_names().size(), names);
}

TEST(OptionName, IsTheNameOfTheTypeInSmallLetters) {
  EXPECT_EQ(option_name("Hertz"), "hertz");
  EXPECT_EQ(option_name("ExactHertzDamp"), "exact_hertz_damp");
  EXPECT_EQ(option_name("Ye2009"), "ye_2009");
}

TEST(NamedImpactLaw, PassesOnWhetherTheContactMayPull) {
  NamedImpactLaw law = named("kelvin");
  EXPECT_NEAR(delivered_restitution(law.between(mass), mass, 0.3), 0.675, 5.1e-4);
  law.may_pull = true;
  EXPECT_NEAR(delivered_restitution(law.between(mass), mass, 0.3), 0.65, 1e-9);
}

TEST(NamedImpactLaw, AcceptsEveryNameInItsSortedList) {
  EXPECT_TRUE(std::ranges::is_sorted(impact_law_names()));
  for (const std::string& name : impact_law_names()) EXPECT_NO_THROW(named(name).check(check)) << name;
}

TEST(NamedImpactLaw, ListsTheNamesWhereOneIsUnknown) {
  const std::string message = message_of([] { named("hertz-damp").check(check); });
  EXPECT_EQ(message.find("Gap \"moat left\": there is no impact law \"hertz-damp\". Choose one of anagnostopoulos, "),
            0U)
      << message;
  for (const std::string& name : impact_law_names()) EXPECT_NE(message.find(name), std::string::npos) << name;
}

TEST(NamedImpactLaw, AsksForTheStiffnessThatTheLawNeeds) {
  EXPECT_EQ(message_of([] {
              NamedImpactLaw{.name = "hertz_damp", .linear_stiffness = 1e9 * N / m, .restitution = 0.5}.check(check);
            }),
            "Gap \"moat left\": hertz_stiffness = 0 N/m^1.5 is not allowed; it must be > 0 N/m^1.5 and finite. "
            "The law hertz_damp needs it.");
  EXPECT_EQ(message_of([] {
              NamedImpactLaw{.name = "kelvin", .hertz_stiffness = 1e9 * N / m_3_2, .restitution = 0.5}.check(check);
            }),
            "Gap \"moat left\": linear_stiffness = 0 N/m is not allowed; it must be > 0 N/m and finite. "
            "The law kelvin needs it.");
}

}  // namespace
}  // namespace moat::testing
