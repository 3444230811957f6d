#include "output/model_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyses/transient.hpp"
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
    EXPECT_EQ(point.weight, 1.0);
  }
  EXPECT_EQ(top, 3.5);
}

TEST(ModelScene, WallsStandExactlyTheClearanceAway) {
  const HandMovedBuilding building;
  const Scene scene = scene_of(building.model);
  EXPECT_DOUBLE_EQ(x_range(scene, cell(scene, CellKind::wall, "moat left wall")).second, -6.1);
  EXPECT_DOUBLE_EQ(x_range(scene, cell(scene, CellKind::wall, "moat right wall")).first, 6.1);
  for (const char* name : {"moat left wall", "moat right wall"})
    for (const int p : cell(scene, CellKind::wall, name).points) {
      EXPECT_EQ(scene.points[static_cast<std::size_t>(p)].node, -1);
      EXPECT_EQ(scene.points[static_cast<std::size_t>(p)].weight, 0.0);
    }
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

class FrameRecorderTest : public testing_output::InFolder {};

TEST_F(FrameRecorderTest, WritesAFrameAtTheStartAndThenAtItsInterval) {
  HandMovedBuilding building;
  {
    FrameRecorder recorder{building.model, folder, 0.1};
    recorder.start(building.move(0.0, 0.0, 0.0));
    for (int i = 1; i <= 10; ++i) recorder.step(building.move(0.04 * i, 0.0, 0.0));
    recorder.finish({building.model, 0.0, true});
  }
  const std::string pvd = testing_output::read_file(folder / "frames.pvd");
  // 0, then the first steps at or after 0.1, 0.2, 0.3 and 0.4 s.
  for (const char* time :
       {"timestep=\"0\"", "timestep=\"0.12\"", "timestep=\"0.2\"", "timestep=\"0.32\"", "timestep=\"0.4\""})
    EXPECT_NE(pvd.find(time), std::string::npos) << time << "\n" << pvd;
  long frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder / "frames"}) {
    EXPECT_EQ(entry.path().extension(), ".vtu");
    ++frames;
  }
  EXPECT_EQ(frames, 5);
}

TEST_F(FrameRecorderTest, RefusesAnIntervalBeforeItWritesAnything) {
  const HandMovedBuilding building;
  EXPECT_EQ(testing_output::message_of<InputError>([&] { FrameRecorder(building.model, folder / "new", -1.0); }),
            "FrameRecorder: interval = -1 s is not allowed; it must be > 0 s and finite.");
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

}  // namespace
}  // namespace moat
