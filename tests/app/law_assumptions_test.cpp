#include "app/law_assumptions.hpp"

#include <gtest/gtest.h>

#include "elements/contact/gap.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/spring_laws.hpp"
#include "structures/moat.hpp"
#include "structures/shear_building.hpp"

namespace moat {
namespace {

using namespace units;

TEST(LawAssumptions, AreThoseOfTheLawsOfTheModel) {
  ModelFacts model;
  for (const char* law : {"HertzDamp", "FrictionPendulum", "Linear", "HertzDamp", ""})
    model.elements.push_back({"an element", "other", law, "lower", "upper", {{"stiffness", 1.0, "N/m"}}});
  const std::vector<std::string> expected{
      "FrictionPendulum: " + std::string{FrictionPendulum::assumption},
      "FrictionPendulum: The weight on it is constant; neither vertical motion nor overturning acts.",
      "HertzDamp: Derived for restitutions near 1; delivers more than it is given: 0.775 for 0.65."};
  EXPECT_EQ(law_assumptions(model), expected);
  model.elements[1].parameters.push_back({"static_weight", 1e6, "N"});
  EXPECT_EQ(law_assumptions(model), (std::vector<std::string>{expected[0], expected[2]}));
  EXPECT_TRUE(law_assumptions({}).empty());
}

TEST(LawAssumptions, NameALawWhoseParametersResultsLack) {
  ModelFacts model;
  model.elements.push_back({"bearing", "bearing", "OwnLaw", "ground", "base", {}});
  model.elements.push_back({"gap", "gap", "OwnContact", "base", "ground", {{"clearance", 0.1, "m"}}});
  EXPECT_EQ(
      law_assumptions(model),
      (std::vector<std::string>{"OwnContact: a law of the script. It lists no parameters(), so results lack them.",
                                "OwnLaw: a law of the script. It lists no parameters(), so results lack them."}));
}

// The names in the facts of a model are those of the lists.
TEST(LawAssumptions, AreFoundInAModel) {
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 1,
                                                 .floor_mass = 1 * tonne,
                                                 .storey_stiffness = 1 * MN / m,
                                                 .base_mass = 1 * tonne,
                                                 .isolation = FrictionPendulum{.radius = 3 * m, .friction = 0.05}});
  add(model, Moat{.around = building.base,
                  .clearance = 10 * cm,
                  .law = ExactHertzDamp{.stiffness = 2e9 * N / m_3_2, .restitution = 0.6}});
  const std::vector<std::string> sentences = law_assumptions(facts_of(model));
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_TRUE(sentences[0].starts_with("FrictionPendulum: The surface"));
  EXPECT_TRUE(sentences[1].starts_with("FrictionPendulum: The weight on it is constant"));
  EXPECT_TRUE(sentences[2].starts_with("ExactHertzDamp: Delivers its restitution"));
}

TEST(LawAssumptions, AreWholeSentences) {
  const auto check = []<class Law>() {
    constexpr std::string_view text = assumption_of<Law>();
    EXPECT_TRUE(text.empty() || text.ends_with('.')) << Law::name;
    EXPECT_LT(text.size(), 120u) << Law::name;
  };
  AllImpactLaws::for_each(check);
  AllSpringLaws::for_each(check);
}

}  // namespace
}  // namespace moat
