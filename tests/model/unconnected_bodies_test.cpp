// The bodies of a model that nothing connects.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elements/gap.hpp"
#include "elements/shear_spring.hpp"
#include "materials/impact_laws.hpp"
#include "model/model.hpp"

namespace moat::testing {
namespace {

using namespace units;

NodeId add_floor(Model& model, const std::string& name, double displacement = 0.0) {
  return add(model, Node{.name = name, .mass = 10 * tonne, .initial_displacement = displacement * m});
}

void add_storey(Model& model, const std::string& name, NodeId lower, NodeId upper) {
  add(model, ShearSpring{.name = name, .lower = lower, .upper = upper, .stiffness = 1 * MN / m});
}

void add_gap(Model& model, const std::string& name, MemberPoint left, MemberPoint right) {
  add(model,
      Gap{.name = name, .left = left, .right = right, .clearance = 1 * cm, .law = Hertz{.stiffness = 1e9 * N / m_3_2}});
}

std::vector<std::string> names_of(const Model& model) {
  std::vector<std::string> names;
  for (const Node& node : model.nodes()) names.push_back(node.name);
  return names;
}

std::vector<Model> bodies_of(Model& model) {
  model.prepare();
  return model.unconnected_bodies();
}

using Names = std::vector<std::string>;

TEST(UnconnectedBodiesOfAModel, AreNoneWhereElementsLeadFromNodeToNode) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b");
  add_storey(model, "1", ground, a);
  add_gap(model, "gap", a, b);
  EXPECT_TRUE(bodies_of(model).empty());
}

TEST(UnconnectedBodiesOfAModel, MeetOnlyAtTheGround) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b", 0.02), c = add_floor(model, "c");
  add_storey(model, "a 1", ground, a);
  add_storey(model, "b 1", ground, b);
  add_storey(model, "a 2", a, c);
  add_gap(model, "wall", b, ground);
  const std::vector<Model> bodies = bodies_of(model);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(names_of(bodies[0]), (Names{"a", "c"}));
  EXPECT_EQ(names_of(bodies[1]), (Names{"b"}));
  EXPECT_TRUE(bodies[0].has_element("a 2"));
  EXPECT_FALSE(bodies[0].has_element("b 1"));
  EXPECT_TRUE(bodies[1].has_element("wall"));
  EXPECT_EQ(bodies[1].displacement(NodeId{0}), 0.02);
  EXPECT_NEAR(bodies[1].committed_forces()[0], 20e3, 1e-9);
  EXPECT_EQ(bodies[0].committed_forces()[1], 0.0);
}

TEST(UnconnectedBodiesOfAModel, AreJoinedByAGapBetweenFloors) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b"), c = add_floor(model, "c");
  add_storey(model, "a 1", ground, a);
  add_storey(model, "b 1", ground, b);
  add_storey(model, "c 1", ground, c);
  add_gap(model, "mid-column", MemberPoint{ground, a, 0.4}, MemberPoint{ground, c, 0.6});
  const std::vector<Model> bodies = bodies_of(model);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(names_of(bodies[0]), (Names{"a", "c"}));
  ASSERT_TRUE(bodies[0].has_element("mid-column"));
  std::set<NodeId> ends;
  for (const auto& block : bodies[0].blocks())
    for (std::size_t e = 0; e < block->size(); ++e)
      if (const MemberEnds* of_gap = block->info(e).member_ends())
        ends.insert({of_gap->first.other, of_gap->second.other});
  EXPECT_EQ(ends, (std::set<NodeId>{NodeId{0}, NodeId{1}}));
}

TEST(UnconnectedBodiesOfAModel, HoldTheirBuildings) {
  Model model;
  const NodeId a = add_floor(model, "a"), b = add_floor(model, "b"), c = add_floor(model, "c");
  for (const auto& [name, node] : {std::pair{"1", a}, {"2", b}, {"3", c}}) add_storey(model, name, ground, node);
  add(model, Building{.name = "East", .base = b});
  // Nothing but the building holds these together: their inertia is one base shear.
  add(model, Building{.name = "West", .base = a, .floors = {c}});
  const std::vector<Model> bodies = bodies_of(model);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(names_of(bodies[0]), (Names{"a", "c"}));
  ASSERT_EQ(bodies[0].buildings().size(), 1U);
  EXPECT_EQ(bodies[0].buildings()[0].name, "West");
  EXPECT_EQ(bodies[0].buildings()[0].floors, std::vector<NodeId>{NodeId{1}});
  EXPECT_EQ(bodies[1].buildings()[0].base, NodeId{0});
}

}  // namespace
}  // namespace moat::testing
