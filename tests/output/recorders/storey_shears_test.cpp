#include "output/recorders/storey_shears.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "elements/contact/gap.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "moved_model.hpp"
#include "output/vtk/model_scene.hpp"
#include "structures/plan_building.hpp"

namespace moat {
namespace {

using namespace units;

TEST(StoreyShears, AddUpTheSpringsBetweenTheSameFloors) {
  Model model;
  const NodeId low = add(model, Node{.name = "low", .mass = 1 * kg}),
               high = add(model, Node{.name = "high", .mass = 1 * kg});
  add(model, ShearSpring{.name = "storey 1", .lower = ground, .upper = low, .stiffness = 1000 * N / m});
  add(model, ShearSpring{.name = "frame", .lower = low, .upper = high, .stiffness = 100 * N / m});
  add(model, ShearSpring{.name = "wall", .lower = low, .upper = high, .stiffness = 20 * N / m});
  add(model, ViscousDamper{.name = "damper", .lower = low, .upper = high, .damping = 5 * N * s / m});
  AnalysisState state{model};
  testing::move_to(state, Vector{{0.01, -0.04}}, Vector{{1.0, 2.0}});
  state.commit();
  StoreyShears shears{model, {{ground, low}, {low, high}}};
  const std::span<const double> values = shears.evaluate(state);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_NEAR(values[0], 10.0, 1e-12);
  EXPECT_NEAR(values[1], -6.0, 1e-12);
}

TEST(StoreyShears, AreWithoutContactsBetweenTheFloors) {
  Model model;
  const NodeId floor = add(model, Node{.name = "floor", .mass = 1 * kg});
  add(model, ShearSpring{.name = "storey", .lower = ground, .upper = floor, .stiffness = 1000 * N / m});
  add(model,
      Gap<LinearElastic>{
          .name = "stop", .left = floor, .right = ground, .clearance = 4 * mm, .law = {.stiffness = 1 * MN / m}});
  AnalysisState state{model};
  testing::move_to(state, Vector{{0.01}});
  testing::commit_with_regimes(state);
  EXPECT_NEAR(state.internal_forces()[floor.index], 10.0 + 6000.0, 1e-9) << "the stop pushes";
  StoreyShears shears{model, {{ground, floor}}};
  EXPECT_NEAR(shears.evaluate(state)[0], 10.0, 1e-12);
}

TEST(StoreyShears, InPlanAreTheLengthOfTheSumOfAllColumns) {
  // Six columns of 2 kN/m along x and y; the floor moves by (4, 3) cm, and turns about its centre, where the columns
  // of a symmetric grid add nothing.
  Model model;
  const PlanBuildingParts tower = add(model, PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                                                          .storeys = 2,
                                                          .floor_mass = 500 * tonne,
                                                          .columns = grid(3, 2, {.stiffness = 2 * kN / m})});
  AnalysisState state{model};
  const auto move = [&](const DiaphragmId& floor, double x, double y, double r) {
    state.trial().displacement[floor.x.index] = x;
    state.trial().displacement[floor.y.index] = y;
    state.trial().displacement[floor.r.index] = r;
  };
  move(tower.floors[0], 0.04, 0.03, 0.002);
  move(tower.floors[1], 0.04, 0.03, 0.001);
  state.evaluate();
  state.commit();
  const Scene scene = scene_of(model);
  ASSERT_EQ(scene.storeys.size(), 2u);
  StoreyShears shears{model, scene.storeys};
  const std::span<const double> values = shears.evaluate(state);
  EXPECT_NEAR(values[0], 6.0 * 2000.0 * 0.05, 1e-9);
  EXPECT_NEAR(values[1], 0.0, 1e-9);
  // Every storey is drawn at the four corners of its floor.
  for (const int storey : {0, 1})
    EXPECT_EQ(std::ranges::count_if(scene.cells, [&](const SceneCell& cell) { return cell.storey == storey; }), 4);
}

}  // namespace
}  // namespace moat
