// Where absolute accelerations are a cubic in time, the guess is exact, over steps of any lengths.
#include "analyses/integrators/acceleration_curvature.hpp"

#include <gtest/gtest.h>

#include "elements/line/spring.hpp"
#include "materials/linear.hpp"

namespace moat {
namespace {

using namespace units;

// Absolute acceleration of a mass, its jerk, and the acceleration of the ground.
double acceleration(double t) { return 0.7 - 1.9 * t + 2.3 * t * t + 5.1 * t * t * t; }
double jerk(double t) { return -1.9 + 4.6 * t + 15.3 * t * t; }
double of_ground(double t) { return 0.4 - 3.0 * t; }

class AccelerationCurvatureTest : public ::testing::Test {
 protected:
  AccelerationCurvatureTest() {
    const NodeId node = add(model, Node{.name = "mass", .mass = 1 * tonne});
    add(model, Spring<Linear>{.name = "spring", .lower = ground, .upper = node, .law = {.stiffness = 1 * kN / m}});
    state.emplace(model);
  }

  // The committed state becomes that of time t.
  void commit(double t) {
    MotionState& trial = state->trial();
    trial = state->motion();
    trial.time = t;
    trial.acceleration[0] = acceleration(t) - of_ground(t);
    trial.jerk[0] = jerk(t);
    state->evaluate();
    state->commit();
  }
  // The addition to the guess of a step from the committed state; `end` need not be reached.
  double added(AccelerationCurvature& curvature, double end) {
    const double start = state->time();
    Vector guess = Vector::Zero(1);
    curvature.add_to(guess, {.length = end - start,
                             .end_time = end,
                             .ground_acceleration = {of_ground(end)},
                             .ground_acceleration_at_start = {of_ground(start)},
                             .start_time = start});
    return guess[0];
  }
  // The cubic above its tangent at the committed state.
  [[nodiscard]] double above_tangent(double end) const {
    const double start = state->time();
    return acceleration(end) - acceleration(start) - (end - start) * jerk(start);
  }

  Model model;
  std::optional<AnalysisState> state;
};

TEST_F(AccelerationCurvatureTest, ContinuesTheCubicThroughTwoSteps) {
  AccelerationCurvature curvature{*state};
  commit(0.1);
  EXPECT_EQ(added(curvature, 0.4), 0.0);
  commit(0.4);
  // Tried with several lengths, the last of which is taken.
  for (const double end : {0.99, 0.9, 0.45, 0.6}) EXPECT_NEAR(added(curvature, end), above_tangent(end), 1e-12) << end;
  commit(0.6);
  for (const double end : {0.61, 0.8, 0.95}) EXPECT_NEAR(added(curvature, end), above_tangent(end), 1e-12) << end;
}

TEST_F(AccelerationCurvatureTest, AddsNothingFarBeyondTheStepBefore) {
  AccelerationCurvature curvature{*state};
  commit(0.1);
  added(curvature, 0.4);
  commit(0.4);
  EXPECT_EQ(added(curvature, 1.01), 0.0);
  EXPECT_NE(added(curvature, 0.99), 0.0);
}

TEST_F(AccelerationCurvatureTest, AddsNothingWithoutAStepBefore) {
  AccelerationCurvature curvature{*state};
  commit(0.1);
  added(curvature, 0.4);
  // The step to 0.3 s was not given.
  commit(0.3);
  EXPECT_EQ(added(curvature, 0.5), 0.0);
  commit(0.5);
  curvature.forget();
  EXPECT_EQ(added(curvature, 0.6), 0.0);
  commit(0.6);
  EXPECT_NE(added(curvature, 0.7), 0.0);
}

}  // namespace
}  // namespace moat
