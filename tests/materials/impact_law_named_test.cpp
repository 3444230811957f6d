#include "materials/impact_law_named.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/units.hpp"
#include "materials/free_impact.hpp"
#include "materials/impact_laws.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Check check{"Gap", "moat left"};
constexpr double mass = 5.5e5;

ImpactLawNamed named(const std::string& name) {
  return {.name = name, .linear_stiffness = 5.8e8 * N / m, .hertz_stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};
}

// Force of the law while it is loaded.
template <class Law>
double force_of(const Law& law, double indentation, double rate) {
  ContactState trial;
  return law.evaluate({ContactPhase::loaded, 0.3}, indentation, rate, trial).force;
}

TEST(ImpactLawNamed, IsTheLawOfThatName) {
  const Stiffness linear = 5.8e8 * N / m;
  const HertzStiffness hertz = 2.95e9 * N / m_3_2;
  const auto expect_same = [](const std::string& name, const auto& law) {
    for (const double rate : {-0.2, 0.25})
      EXPECT_EQ(force_of(named(name).between(mass), 0.01, rate), force_of(law.between(mass), 0.01, rate)) << name;
  };
  expect_same("linear_elastic", LinearElastic{linear});
  expect_same("hertz", Hertz{hertz});
  expect_same("kelvin", Kelvin{linear, 0.65});
  expect_same("anagnostopoulos", Anagnostopoulos{linear, 0.65});
  expect_same("modified_linear_viscoelastic", ModifiedLinearViscoelastic{linear, 0.65});
  expect_same("exact_kelvin", ExactKelvin{linear, 0.65});
  expect_same("hertz_damp", HertzDamp{hertz, 0.65});
  expect_same("lankarani_nikravesh", LankaraniNikravesh{hertz, 0.65});
  expect_same("hunt_crossley", HuntCrossley{hertz, 0.65});
  expect_same("ye_2009", Ye2009{hertz, 0.65});
  expect_same("hu_guo", HuGuo{hertz, 0.65});
  expect_same("gonthier", Gonthier{hertz, 0.65});
  expect_same("nonlinear_viscoelastic", NonlinearViscoelastic{hertz, 0.65});
  expect_same("modified_hertz_damp", ModifiedHertzDamp{hertz, 0.65});
  expect_same("modified_hertz_damp_printed", ModifiedHertzDampPrinted{hertz, 0.65});
  expect_same("exact_hertz_damp", ExactHertzDamp{hertz, 0.65});
  EXPECT_EQ(impact_law_names().size(), 16U);
}

TEST(ImpactLawNamed, PassesOnWhetherTheContactMayPull) {
  ImpactLawNamed law = named("kelvin");
  EXPECT_NEAR(delivered_restitution(law.between(mass), mass, 0.3), 0.675, 5.1e-4);
  law.may_pull = true;
  EXPECT_NEAR(delivered_restitution(law.between(mass), mass, 0.3), 0.65, 1e-9);
}

TEST(ImpactLawNamed, AcceptsEveryNameInItsSortedList) {
  EXPECT_TRUE(std::ranges::is_sorted(impact_law_names()));
  for (const std::string_view name : impact_law_names()) EXPECT_NO_THROW(named(std::string{name}).check(check)) << name;
}

TEST(ImpactLawNamed, ListsTheNamesWhereOneIsUnknown) {
  const std::string message = message_of([] { named("hertz-damp").check(check); });
  EXPECT_EQ(message.find("Gap \"moat left\": there is no impact law \"hertz-damp\". Choose one of anagnostopoulos, "),
            0U)
      << message;
  for (const std::string_view name : impact_law_names()) EXPECT_NE(message.find(name), std::string::npos) << name;
}

TEST(ImpactLawNamed, AsksForTheStiffnessThatTheLawNeeds) {
  EXPECT_EQ(message_of([] {
              ImpactLawNamed{.name = "hertz_damp", .linear_stiffness = 1e9 * N / m, .restitution = 0.5}.check(check);
            }),
            "Gap \"moat left\": hertz_stiffness = 0 N/m^1.5 is not allowed; it must be > 0 N/m^1.5 and finite. "
            "The law hertz_damp needs it.");
  EXPECT_EQ(message_of([] {
              ImpactLawNamed{.name = "kelvin", .hertz_stiffness = 1e9 * N / m_3_2, .restitution = 0.5}.check(check);
            }),
            "Gap \"moat left\": linear_stiffness = 0 N/m is not allowed; it must be > 0 N/m and finite. "
            "The law kelvin needs it.");
}

}  // namespace
}  // namespace moat::testing
