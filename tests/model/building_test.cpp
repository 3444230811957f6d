#include "moat.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

NodeId add_floor(Model& model, const std::string& name) { return add(model, Node{.name = name, .mass = 1 * tonne}); }

void join(Model& model, NodeId lower, NodeId upper) {
  add(model,
      ShearSpring{
          .name = "spring " + std::to_string(upper.index), .lower = lower, .upper = upper, .stiffness = 1 * MN / m});
}

TEST(Building, RefusesNodesThatDoNotFit) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b");
  add(model, Building{.name = "house", .base = a});
  const auto refusal = [&](const Building& building) { return message_of([&] { add(model, building); }); };
  EXPECT_EQ(refusal({.name = "shed"}),
            "Building \"shed\": no floors are given. Give .base and .floors, from the lowest up.");
  EXPECT_EQ(refusal({.name = "shed", .base = b, .floors = {ground}}),
            "Building \"shed\": the ground is among the floors. List only nodes with mass.");
  EXPECT_EQ(refusal({.name = "shed", .base = NodeId{2}}),
            "Building \"shed\": base is not a node of this model. Use the NodeId that add(model, Node{...}) "
            "returned.");
  EXPECT_EQ(refusal({.base = b, .floors = {NodeId{}}}),
            "Building: a floor is not given. Set it to a node of this model or to `ground`.");
  EXPECT_EQ(refusal({.name = "house", .base = b}),
            "Building \"house\": a building of this name exists. Give every building its own .name.");
  EXPECT_EQ(refusal({.name = "shed", .base = a}),
            "Building \"shed\": the node \"a\" is in a building already. Its inertia would count twice.");
  EXPECT_EQ(refusal({.name = "barn", .base = b, .floors = {b}}),
            "Building \"barn\": the node \"b\" is in a building already. Its inertia would count twice.");
}

TEST(Building, KnowsItsNodesAndItsName) {
  const NodeId base{0}, first{1}, second{2};
  const Building isolated{.base = base, .floors = {first, second}}, fixed{.name = "old", .floors = {first}};
  EXPECT_EQ(isolated.nodes(), (std::vector<NodeId>{base, first, second}));
  EXPECT_EQ(isolated.top(), second);
  EXPECT_EQ(isolated.base_name(), "base");
  EXPECT_EQ(fixed.nodes(), (std::vector<NodeId>{first}));
  EXPECT_EQ(fixed.base_name(), "old base");
  EXPECT_EQ((Building{.base = base}.top()), base);
}

// A building on two slabs, one that shares its base and adds a slab, and one on that slab: the first counts all.
TEST(Building, CarriesWhatStandsOnItsSlabs) {
  Model model;
  const NodeId base = add_floor(model, "base"), slab = add_floor(model, "slab"), floor = add_floor(model, "floor"),
               third = add_floor(model, "third"), tower = add_floor(model, "tower"), mast = add_floor(model, "mast");
  const Building first{.name = "first", .base = base, .floors = {floor}, .slabs = {slab}},
      second{.name = "second", .base = slab, .floors = {tower}, .slabs = {third}, .shares_base = true},
      last{.name = "last", .base = third, .floors = {mast}, .shares_base = true};
  EXPECT_EQ(first.nodes(), (std::vector<NodeId>{base, slab, floor}));
  EXPECT_EQ(second.nodes(), (std::vector<NodeId>{third, tower}));
  for (const Building& each : {first, second, last}) add(model, each);
  EXPECT_EQ(carried_nodes(model, first), (std::vector<NodeId>{base, slab, floor, third, tower, mast}));
  EXPECT_TRUE(carried_nodes(model, second).empty());
  add(model, Isolator{.name = "pads", .upper = slab, .law = Linear{.stiffness = 1 * MN / m}});
  EXPECT_EQ(isolators_of(model, model.buildings())[0].size(), 1U);
}

TEST(Building, IsolatorsBelongToTheBuildingAboveThem) {
  Model model;
  const NodeId north = add_floor(model, "north"), south = add_floor(model, "south");
  add(model, Isolator{.name = "first", .upper = south, .law = Linear{.stiffness = 1 * MN / m}});
  add(model, Isolator{.name = "second", .upper = south, .law = Linear{.stiffness = 1 * MN / m}});
  const std::vector<Building> buildings{{.name = "north", .base = north}, {.name = "south", .base = south}};
  const auto isolators = isolators_of(model, buildings);
  EXPECT_TRUE(isolators[0].empty());
  ASSERT_EQ(isolators[1].size(), 2u);
  const ElementId id = isolators[1][1];
  EXPECT_EQ(model.blocks()[id.block]->info(id.element).name, "second");
}

TEST(Building, PartsAreJoinedByElementsButNotByGapsOrTheGround) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b"), c = add_floor(model, "c");
  join(model, ground, a);
  join(model, a, b);
  join(model, ground, c);
  add(model, Gap{.name = "gap",
                 .left = b,
                 .right = c,
                 .clearance = 1 * cm,
                 .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.5}});
  const std::vector<int> part = connected_parts(model);
  EXPECT_EQ(part[0], part[1]);
  EXPECT_NE(part[0], part[2]);
}

TEST(Building, BodiesBesideTheBuildingsAreListedByTheirFirstNode) {
  Model model;
  const NodeId base = add_floor(model, "base"), floor = add_floor(model, "floor 1"), tank = add_floor(model, "tank"),
               deck = add_floor(model, "deck"), roof = add_floor(model, "roof");
  join(model, base, floor);
  join(model, floor, tank);  // part of the building's body, but not one of its floors
  add(model, Isolator{.name = "pads", .upper = deck, .law = Linear{.stiffness = 1 * MN / m}});
  join(model, deck, roof);
  add(model, Building{.name = "tower", .base = base, .floors = {floor}});
  const std::vector<Building> all = all_buildings(model);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "tower");
  EXPECT_EQ(all[1].name, "deck");
  EXPECT_EQ(all[1].base, deck);
  EXPECT_EQ(all[1].floors, (std::vector<NodeId>{roof}));
}

}  // namespace
}  // namespace moat
