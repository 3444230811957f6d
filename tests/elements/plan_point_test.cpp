// Points of bodies in plan, and how far they move along a direction.
#include "elements/block/plan_point.hpp"

#include <gtest/gtest.h>

#include "moat.hpp"

namespace moat {
namespace {

using namespace units;

TEST(PlanPoint, OfAWallMovesByThePartAlongTheDirection) {
  Model model;
  add(model, Diaphragm{.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .free = true});
  const NodeId wall = add(model, Node{.name = "wall", .mass = 1 * kg, .direction = PlanVector{0.6, -0.8}});
  const PlanRow row = row_of(model, wall, {3 * m, 4 * m}, {0.0, 2.0});
  EXPECT_EQ(row.node[0], wall);
  EXPECT_NEAR(row.weight[0], -1.6, 1e-15) << "displacements scale with the direction";
  EXPECT_EQ(row.weight[1], 0.0);
  EXPECT_EQ(row.weight[2], 0.0);
}

TEST(PlanPoint, OfADiaphragmTurnsWithIt) {
  Model model;
  const DiaphragmId floor =
      add(model, Diaphragm{.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .free = true});
  // Displacement of (x, y) is u + w (-y, x).
  const PlanRow along_x = row_of(model, floor, {3 * m, 4 * m}, {1.0, 0.0}),
                along_y = row_of(model, floor, {3 * m, 4 * m}, {0.0, 1.0});
  EXPECT_NEAR(along_x.weight[0], 1.0, 1e-15);
  EXPECT_NEAR(along_y.weight[1], 1.0, 1e-15);
  EXPECT_NEAR(along_x.weight[2] / along_y.weight[2], -4.0 / 3.0, 1e-12);
}

}  // namespace
}  // namespace moat
