#include "output/files/model_facts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "moat.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

TEST(ModelFacts, HoldNodesAndElementsInTheirOrder) {
  const testing_output::HandMovedBuilding building;
  const ModelFacts facts = facts_of(building.model);
  ASSERT_EQ(facts.nodes.size(), 2u);
  EXPECT_EQ(facts.nodes[1].name, "floor 1");
  EXPECT_EQ(facts.nodes[1].mass, 3.0);
  EXPECT_EQ(facts.nodes[1].height, 3.5);
  ASSERT_EQ(facts.elements.size(), 5u);
  EXPECT_EQ(facts.elements[0].name, "storey 1");
  EXPECT_EQ(facts.elements[0].first, "base");
  EXPECT_EQ(facts.elements[0].second, "floor 1");
  EXPECT_EQ(facts.elements[0].law, "Linear");
  ASSERT_FALSE(facts.elements[0].parameters.empty());
  EXPECT_EQ(facts.elements[0].parameters[0].name, "stiffness");
  EXPECT_EQ(facts.elements[0].parameters[0].value, 100.0);
  EXPECT_EQ(facts.elements[0].parameters[0].unit, "N/m");
}

TEST(ModelFacts, HaveInitialMotionsAndPointsBetweenNodes) {
  using namespace units;
  Model model;
  const NodeId lower = add(model, Node{.name = "lower", .mass = 1 * kg, .initial_displacement = 2 * cm});
  const NodeId upper = add(model, Node{.name = "upper", .mass = 1 * kg, .initial_velocity = 3 * m / s});
  const NodeId other = add(model, Node{.name = "other", .mass = 1 * kg});
  add(model, Gap{.name = "column",
                 .left = MemberPoint{lower, upper, 0.25},
                 .right = other,
                 .clearance = 1 * cm,
                 .law = LinearElastic{.stiffness = 1 * MN / m}});
  const ModelFacts facts = facts_of(model);
  EXPECT_EQ(facts.nodes[0].initial_displacement, 0.02);
  EXPECT_EQ(facts.nodes[1].initial_velocity, 3.0);
  const ElementFacts& gap = facts.elements.at(0);
  EXPECT_EQ(gap.kind, "gap");
  EXPECT_EQ(gap.first, "other");
  EXPECT_EQ(gap.first_other, "");
  EXPECT_EQ(gap.second, "lower");
  EXPECT_EQ(gap.second_other, "upper");
  EXPECT_EQ(gap.second_share, 0.25);
}

// In plan too, where bearings are not drawn by their elements.
TEST(ModelFacts, HaveTheKindOfEveryElement) {
  using namespace units;
  Model model;
  const DiaphragmId floor = add(model, Diaphragm{.name = "floor", .mass = 100 * tonne, .size = {10 * m, 8 * m}});
  add(model,
      PlanBearing{.name = "bearing",
                  .under = floor,
                  .law = BiaxialBilinear{
                      .yield_force = 100 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m}});
  EXPECT_EQ(facts_of(model).elements.at(0).kind, "bearing");
  const testing_output::HandMovedBuilding building;
  std::map<std::string, std::string> kinds;
  for (const ElementFacts& element : facts_of(building.model).elements) kinds[element.name] = element.kind;
  EXPECT_EQ(kinds.at("storey 1"), "storey");
  EXPECT_EQ(kinds.at("moat left"), "gap");
}

TEST(ModelFacts, HaveTheClearanceOfEveryGap) {
  const testing_output::HandMovedBuilding building;
  const ModelFacts facts = facts_of(building.model);
  const auto gap = std::ranges::find(facts.elements, "moat left", &ElementFacts::name);
  ASSERT_NE(gap, facts.elements.end());
  EXPECT_EQ(gap->law, "HertzDamp");
  EXPECT_EQ(gap->second, "ground");
  ASSERT_EQ(gap->parameters.size(), 4u);
  EXPECT_EQ(gap->parameters[0].name, "clearance");
  EXPECT_EQ(gap->parameters[0].value, 0.1);
  EXPECT_EQ(gap->parameters[2].name, "restitution");
  EXPECT_EQ(gap->parameters[2].value, 1.0);
}

TEST(ModelFacts, HavePlacesAndDirectionsInPlan) {
  using namespace units;
  Model model;
  const DiaphragmId floor = add(model, Diaphragm{.name = "floor",
                                                 .mass = 10 * kg,
                                                 .rotary_inertia = 90 * kg * m * m,
                                                 .centre_of_mass = {1 * m, 2 * m},
                                                 .outline = rectangle(4 * m, 6 * m)});
  add(model, PlanSpring{.name = "link",
                        .lower = PlanPoint{ground, {3 * m, 4 * m}},
                        .upper = PlanPoint{floor, {1 * m, 4 * m}},
                        .direction = {2.0, 0.0},
                        .law = Linear{.stiffness = 1 * N / m}});
  const ModelFacts facts = facts_of(model);
  ASSERT_EQ(facts.elements.size(), 1u);
  EXPECT_EQ(facts.elements[0].first, "ground");
  EXPECT_EQ(facts.elements[0].second, "floor");
  ASSERT_TRUE(facts.elements[0].plan_places);
  EXPECT_EQ(facts.elements[0].plan_places->first, (PlanVector{3.0, 4.0}));
  EXPECT_EQ(facts.elements[0].plan_places->second, (PlanVector{1.0, 4.0}));
  EXPECT_EQ(facts.elements[0].plan_places->direction, (PlanVector{1.0, 0.0}));
  ASSERT_EQ(facts.diaphragms.size(), 1u);
  EXPECT_NEAR(facts.diaphragms[0].gyration, 3.0, 1e-15);
}

}  // namespace
}  // namespace moat
