// A path of several pieces is the motion of the exponential.
#include "analyses/linear_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elements/spring.hpp"
#include "exponential_motion.hpp"
#include "materials/linear.hpp"
#include "motions/ground_motion.hpp"

namespace moat {
namespace {

using namespace units;

constexpr Eigen::Index count = 3;
constexpr double piece = 0.01;  // s

// A building of three storeys that moves at the start of a step.
class LinearPathTest : public ::testing::Test {
 protected:
  LinearPathTest() {
    NodeId lower = ground;
    for (const char* name : {"first", "second", "third"}) {
      const NodeId upper = add(model, Node{.name = name, .mass = 1e3 * kg});
      add(model, Spring<Linear>{.name = "below " + std::string{name},
                                .lower = lower,
                                .upper = upper,
                                .law = {.stiffness = 200 * kN / m, .damping = 300 * N * s / m}});
      lower = upper;
    }
    model.prepare();
    const testing::Tangents tangents{model};
    system.emplace(tangents.stiffness, tangents.damping, model.masses(), piece);
    exact.emplace(model, tangents, offset);
    model.trial().displacement.head(count) << 0.01, -0.02, 0.03;
    model.trial().velocity.head(count) << 0.5, 0.1, -0.4;
  }

  [[nodiscard]] Vector start() const {
    Vector motion(2 * count);
    motion << model.trial().displacement.head(count), model.trial().velocity.head(count);
    return motion;
  }

  void begin(const StepTask& step) { path.begin(*system, offset, model.trial(), step); }
  // u, u', u'' and the absolute jerk after h s.
  [[nodiscard]] Vector at(double h) {
    MotionState motion = model.trial();
    path.move(h, motion);
    Vector all(4 * count);
    all << motion.displacement.head(count), motion.velocity.head(count), motion.acceleration.head(count),
        motion.jerk.head(count);
    return all;
  }

  Model model;
  LinearPath path;
  const Vector offset{{0.3, -0.2, 0.1}};
  std::optional<LinearSystem> system;
  std::optional<testing::ExponentialMotion> exact;
};

void expect_equal(const Vector& found, const Vector& exact, double time) {
  for (Eigen::Index i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(found[i], exact[i], 1e-12 * std::max(1.0, std::abs(exact[i]))) << time << " " << i;
}

// The ground accelerates as 2 + 30 t (m/s^2). The step begins between multiples of the piece.
StepTask step_of(double start, double length) {
  return {.length = length,
          .end_time = start + length,
          .ground_acceleration = {2.0 + 30.0 * (start + length), 0.0},
          .ground_jerk = {30.0, 0.0},
          .ground_acceleration_at_start = {2.0 + 30.0 * start, 0.0},
          .start_time = start};
}

TEST_F(LinearPathTest, IsTheExponentialUnderASteadySlopeOfTheGround) {
  const StepTask step = step_of(0.004, 0.113);
  begin(step);
  // A piece to the first multiple, ten whole ones, and the rest.
  ASSERT_EQ(path.pieces(), 12);
  EXPECT_EQ(path.start_of(0), 0.0);
  for (Eigen::Index i = 1; i < 12; ++i) EXPECT_DOUBLE_EQ(path.start_of(i), 0.006 + piece * static_cast<double>(i - 1));
  EXPECT_EQ(path.start_of(12), 0.113);
  // Ends and insides of pieces, not in their order.
  for (const double h : {0.02, step.length, 0.001, path.start_of(2), 0.056, path.start_of(1), 0.0299, 0.0001, 0.11})
    expect_equal(at(h), exact->after(h, start(), 2.0 + 30.0 * 0.004, 30.0), h);
  for (Eigen::Index i = 1; i <= path.pieces(); ++i) {
    const double time = path.start_of(i);
    EXPECT_NEAR(path.ground_at(i), 2.0 + 30.0 * (0.004 + time), 1e-12);
    expect_equal(at(time), exact->after(time, start(), 2.0 + 30.0 * 0.004, 30.0), time);
  }
}

// A step has as many pieces as steps of the system, so that it is looked at inside.
TEST_F(LinearPathTest, IsKnownInside) {
  for (const auto& [length, pieces] : {std::pair{0.5, 1}, {1.0, 1}, {1.5, 2}, {2.0, 2}, {7.0, 7}, {32.0, 32}}) {
    begin(step_of(0.0, length * piece));
    EXPECT_EQ(path.pieces(), pieces) << length;
  }
}

// A path over samples follows the bends of the ground's acceleration.
TEST_F(LinearPathTest, FollowsTheSamplesOfTheGround) {
  const std::vector<double> samples{0.0, 2.0, -1.0, 3.0, 1.0, 0.5, -2.0, -2.5, 0.3};
  const GroundMotion motion{"to and fro", piece, samples};
  StepTask whole{.length = 8 * piece, .end_time = 8 * piece, .ground_acceleration = {samples.back(), 0.0}};
  whole.ground.emplace(motion, 0.0, whole.length);
  begin(whole);
  ASSERT_EQ(path.pieces(), 8);
  EXPECT_NEAR(path.ground_at(4), samples[4], 1e-12);
  Vector at_sample = start();
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    const double time = static_cast<double>(k) * piece, slope = (samples[k + 1] - samples[k]) / piece;
    const Vector middle = exact->after(0.4 * piece, at_sample, samples[k], slope);
    expect_equal(at(time + 0.4 * piece), middle, time);
    at_sample = exact->after(piece, at_sample, samples[k], slope);
    expect_equal(at(time + piece), at_sample, time);
    at_sample.conservativeResize(2 * count);
  }
}

}  // namespace
}  // namespace moat
