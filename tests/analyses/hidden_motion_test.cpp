// Bumps of the ground inside a step are compared with displacements and margins.
#include "analyses/hidden_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "elements/shear_spring.hpp"
#include "motions/ground_motion.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double far = std::numeric_limits<double>::infinity();  // from every margin

// Two buildings that nothing connects.
class HiddenMotionTest : public ::testing::Test {
 protected:
  HiddenMotionTest() {
    for (const char* name : {"isolated", "stiff"}) {
      const NodeId body = add(model, Node{.name = name, .mass = 1e4 * kg});
      add(model,
          ShearSpring{.name = std::string{name} + " spring", .lower = ground, .upper = body, .stiffness = 1 * MN / m});
    }
    model.prepare();
    task.ground.emplace(motion, 0.0, task.length);
    task.ground->for_each_bump_inside([&](const GroundBump& b) { bump = std::max(bump, std::abs(b.displacement)); });
  }

  void move(double isolated, double stiff) {
    model.trial().displacement.head(2) << isolated, stiff;
    model.evaluate();
    model.commit(WorkRule::quadrature);
    model.trial() = model.state();
  }

  GroundMotion motion{"to and fro", 0.01, {0.0, 2.0, -1.0, 3.0, 1.0}};
  StepTask task{.length = 0.04, .end_time = 0.04};
  Model model;
  double bump = 0.0;  // m, the largest inside the step
};

TEST_F(HiddenMotionTest, IsComparedWithTheLargestDisplacementSoFar) {
  HiddenMotion hidden{model};
  move(1.0, 1.0);
  EXPECT_FALSE(hidden.in(task, model, far));
  // Both pass zero.
  move(0.0, 0.0);
  EXPECT_FALSE(hidden.in(task, model, far));
  EXPECT_TRUE(HiddenMotion{model}.in(task, model, far));
}

TEST_F(HiddenMotionTest, IsComparedWithTheBuildingThatMovesLeast) {
  HiddenMotion hidden{model};
  move(100.0, 0.9e4 * bump);
  EXPECT_TRUE(hidden.in(task, model, far));
  move(100.0, 1.1e4 * bump);
  EXPECT_FALSE(hidden.in(task, model, far));
}

TEST_F(HiddenMotionTest, IsComparedWithHalfTheMargin) {
  HiddenMotion hidden{model};
  move(100.0, 100.0);
  EXPECT_TRUE(hidden.in(task, model, 1.9 * bump));
  EXPECT_FALSE(hidden.in(task, model, 2.1 * bump));
}

TEST_F(HiddenMotionTest, KnowsMarginsThatDecideIt) {
  HiddenMotion hidden{model};
  EXPECT_TRUE(hidden.is_close(far));  // nothing moved yet
  move(0.5, 2.0);
  static_cast<void>(hidden.in(task, model, far));
  EXPECT_TRUE(hidden.is_close(0.0));
  EXPECT_TRUE(hidden.is_close(0.9e-4));
  EXPECT_FALSE(hidden.is_close(1.1e-4));
}

TEST_F(HiddenMotionTest, IsNoneWithinAnIntervalOfTheSamples) {
  task.ground.reset();
  EXPECT_FALSE(HiddenMotion{model}.in(task, model, 0.0));
}

}  // namespace
}  // namespace moat
