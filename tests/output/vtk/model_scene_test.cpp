#include "output/vtk/model_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "analyses/time_history/transient.hpp"
#include "output/vtk/scene_spread.hpp"
#include "output_testing.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using namespace units;
using testing_output::HandMovedBuilding;

const SceneCell& cell(const Scene& scene, CellKind kind, const std::string& name) {
  const auto found = std::find_if(scene.cells.begin(), scene.cells.end(),
                                  [&](const SceneCell& c) { return c.kind == kind && c.name == name; });
  if (found == scene.cells.end()) throw std::runtime_error{"no cell " + name};
  return *found;
}

long count(const Scene& scene, CellKind kind) {
  return std::count_if(scene.cells.begin(), scene.cells.end(), [&](const SceneCell& c) { return c.kind == kind; });
}

std::pair<double, double> x_range(const Scene& scene, const SceneCell& c) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const int p : c.points) {
    low = std::min(low, scene.points[static_cast<std::size_t>(p)].x);
    high = std::max(high, scene.points[static_cast<std::size_t>(p)].x);
  }
  return {low, high};
}

TEST(ModelScene, DrawsEveryNodeAndEveryElementButDampers) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  EXPECT_EQ(count(scene, CellKind::floor), 2);
  EXPECT_EQ(count(scene, CellKind::storey), 1);
  EXPECT_EQ(count(scene, CellKind::bearing), 1);
  EXPECT_EQ(count(scene, CellKind::gap), 2);
  EXPECT_EQ(count(scene, CellKind::wall), 2);
  EXPECT_EQ(count(scene, CellKind::other), 0);
  for (const char* name : {"base", "floor 1"}) EXPECT_EQ(cell(scene, CellKind::floor, name).points.size(), 4u);
}

TEST(ModelScene, AFloorIsAsWideAndHighAsItsNodeSaysAndMovesWithIt) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  const SceneCell& floor = cell(scene, CellKind::floor, "floor 1");
  EXPECT_EQ(x_range(scene, floor), (std::pair{-5.0, 5.0}));
  double top = -1.0;
  for (const int p : floor.points) {
    const ScenePoint& point = scene.points[static_cast<std::size_t>(p)];
    top = std::max(top, point.z);
    EXPECT_EQ(point.node, building.floor.index);
  }
  EXPECT_EQ(top, 3.5);
}

TEST(ModelScene, WallsStandExactlyTheClearanceAway) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  EXPECT_DOUBLE_EQ(x_range(scene, cell(scene, CellKind::wall, "moat left wall")).second, -6.1);
  EXPECT_DOUBLE_EQ(x_range(scene, cell(scene, CellKind::wall, "moat right wall")).first, 6.1);
  for (const char* name : {"moat left wall", "moat right wall"})
    for (const int p : cell(scene, CellKind::wall, name).points)
      EXPECT_EQ(scene.points[static_cast<std::size_t>(p)].node, -1);
  for (const char* name : {"moat left", "moat right"}) {
    const auto [low, high] = x_range(scene, cell(scene, CellKind::gap, name));
    EXPECT_NEAR(high - low, 0.1, 1e-12) << name;
  }
}

TEST(ModelScene, AGapBetweenTwoBuildingsHasNoWall) {
  Model model;
  const NodeId left = add(model, Node{.name = "left", .mass = 1 * kg, .half_width = 4 * m});
  const NodeId right = add(model, Node{.name = "right", .mass = 1 * kg, .x = 9.2 * m, .half_width = 5 * m});
  add(model, Gap<HertzDamp>{.name = "gap",
                            .left = left,
                            .right = right,
                            .clearance = 20 * cm,
                            .law = {.stiffness = 1 * N / m_3_2, .restitution = 1.0}});
  const Scene scene = scene_of(model);
  EXPECT_EQ(count(scene, CellKind::wall), 0);
  const auto [low, high] = x_range(scene, cell(scene, CellKind::gap, "gap"));
  EXPECT_DOUBLE_EQ(low, 4.0);
  EXPECT_DOUBLE_EQ(high, 4.2);
}

TEST(ModelScene, AGapAtAColumnIsDrawnAtItsHeight) {
  Model model;
  const NodeId roof = add(model, Node{.name = "roof", .mass = 1 * kg, .height = 5 * m});
  const NodeId lower = add(model, Node{.name = "lower", .mass = 1 * kg, .x = 10 * m, .height = 4 * m});
  const NodeId upper = add(model, Node{.name = "upper", .mass = 1 * kg, .x = 10 * m, .height = 8 * m});
  add(model, ShearSpring{.name = "column", .lower = lower, .upper = upper, .stiffness = 1 * N / m});
  add(model, Gap<HertzDamp>{.name = "gap",
                            .left = roof,
                            .right = MemberPoint{lower, upper, 0.25},
                            .clearance = 20 * cm,
                            .law = {.stiffness = 1 * N / m_3_2, .restitution = 1.0}});
  const Scene scene = scene_of(model);
  const SceneCell& gap = cell(scene, CellKind::gap, "gap");
  const SceneCell& slab = cell(scene, CellKind::floor, "roof");
  const auto height = [&](int point) { return scene.points[static_cast<std::size_t>(point)].z; };
  EXPECT_DOUBLE_EQ(height(gap.points[0]), 0.5 * (height(slab.points[0]) + height(slab.points[2])));
}

TEST(ModelScene, AWallAtAColumnIsDrawnAtTheHeightOfTheGap) {
  Model model;
  const NodeId lower = add(model, Node{.name = "lower", .mass = 1 * kg, .height = 4 * m});
  const NodeId upper = add(model, Node{.name = "upper", .mass = 1 * kg, .height = 8 * m});
  add(model, ShearSpring{.name = "column", .lower = lower, .upper = upper, .stiffness = 1 * N / m});
  add(model, Gap<HertzDamp>{.name = "gap",
                            .left = MemberPoint{lower, upper, 0.25},
                            .right = ground,
                            .clearance = 20 * cm,
                            .law = {.stiffness = 1 * N / m_3_2, .restitution = 1.0}});
  const Scene scene = scene_of(model);
  const auto height = [&](int point) { return scene.points[static_cast<std::size_t>(point)].z; };
  const SceneCell& slab = cell(scene, CellKind::floor, "lower");
  // A quarter of the way from 4 m to 8 m.
  EXPECT_DOUBLE_EQ(height(cell(scene, CellKind::gap, "gap").points[0]),
                   0.5 * (height(slab.points[0]) + height(slab.points[2])) + 1.0);
}

// Places of a cell's points in a drawing with displacements `factor` times larger, at rest.
std::vector<double> drawn_x(const Scene& scene, const SceneCell& c, double factor) {
  std::vector<double> places;
  for (const int p : c.points) {
    const ScenePoint& point = scene.points[static_cast<std::size_t>(p)];
    places.push_back(point.x + (factor - 1.0) * point.spread.x);
  }
  return places;
}

TEST(ModelScene, AGapIsDrawnWiderByTheFactorOfTheDisplacements) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  for (const double factor : {1.0, 2.0, 50.0}) {
    for (const char* name : {"moat left", "moat right"}) {
      const std::vector<double> ends = drawn_x(scene, cell(scene, CellKind::gap, name), factor);
      EXPECT_NEAR(ends[1] - ends[0], factor * 0.1, 1e-9) << name;
    }
    for (const char* name : {"base", "floor 1"})
      EXPECT_EQ(drawn_x(scene, cell(scene, CellKind::floor, name), factor),
                drawn_x(scene, cell(scene, CellKind::floor, name), 1.0));
    const std::vector<double> wall = drawn_x(scene, cell(scene, CellKind::wall, "moat right wall"), factor);
    EXPECT_NEAR(wall[0], 6.0 + factor * 0.1, 1e-9);
    EXPECT_NEAR(wall[1] - wall[0], 1.0, 1e-9) << "a wall keeps its thickness";
  }
}

TEST(ModelScene, BodiesOfAStreetSpreadOneBehindTheOther) {
  Model model;
  std::vector<NodeId> nodes;
  for (int i = 0; i < 4; ++i)
    nodes.push_back(
        add(model, Node{.name = "body " + std::to_string(i), .mass = 1 * kg, .x = 10.0 * i * m, .half_width = 4 * m}));
  // Bodies 1 and 2 are joined, so that they move apart together.
  add(model, ShearSpring{.name = "joint", .lower = nodes[1], .upper = nodes[2], .stiffness = 1 * N / m});
  const auto gap = [&](const std::string& name, int left, int right, Length clearance) {
    add(model, Gap<HertzDamp>{.name = name,
                              .left = nodes[static_cast<std::size_t>(left)],
                              .right = nodes[static_cast<std::size_t>(right)],
                              .clearance = clearance,
                              .law = {.stiffness = 1 * N / m_3_2, .restitution = 1.0}});
  };
  gap("wide", 0, 2, 30 * cm);
  gap("narrow", 0, 1, 20 * cm);
  gap("last", 2, 3, 10 * cm);
  const std::vector<PlanVector> spread = spread_of_nodes(model);
  const std::vector<double> expected{0.0, 0.2, 0.2, 0.3};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(spread[i].x, expected[i], 1e-12) << i;
}

TEST(ModelScene, ElementsAreNumberedThroughAllBlocks) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  int number = 0;
  for (const auto& block : building.model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e, ++number) {
      if (block->info(e).drawn_as == DrawnAs::nothing) continue;
      const auto found =
          std::find_if(scene.cells.begin(), scene.cells.end(), [&](const SceneCell& c) { return c.element == number; });
      ASSERT_NE(found, scene.cells.end()) << number;
      EXPECT_EQ(found->name, block->info(e).name);
    }
  for (const CellKind kind : {CellKind::floor, CellKind::wall})
    for (const SceneCell& c : scene.cells)
      if (c.kind == kind) {
        EXPECT_EQ(c.element, -1);
      }
}

}  // namespace
}  // namespace moat
