// A path of several pieces is the motion that one series describes.
#include "analyses/linear_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
    const Vector offset{{0.3, -0.2, 0.1}};
    system.emplace(tangents.stiffness, tangents.damping, model.masses(), piece);
    system->set_offset(offset);
    exact.emplace(model, tangents, offset);
    model.trial().displacement.head(count) << 0.01, -0.02, 0.03;
    model.trial().velocity.head(count) << 0.5, 0.1, -0.4;
  }

  [[nodiscard]] Vector start() const {
    Vector motion(2 * count);
    motion << model.trial().displacement.head(count), model.trial().velocity.head(count);
    return motion;
  }

  Model model;
  std::optional<LinearSystem> system;
  std::optional<testing::ExponentialMotion> exact;
};

void expect_equal(const double* found, const Vector& exact, double time) {
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
  LinearPath path{count};
  path.begin(*system, model.trial(), step);
  // A piece to the first multiple, four at once twice, two, and the rest.
  const std::array starts{0.0, 0.006, 0.046, 0.086, 0.106, 0.113};
  ASSERT_EQ(path.parts() + 1, starts.size());
  for (std::size_t part = 0; part <= path.parts(); ++part) EXPECT_DOUBLE_EQ(path.start_of(part), starts.at(part));
  // Ends and insides of parts and of their pieces, not in their order.
  for (const double h : {0.02, step.length, 0.001, path.start_of(2), 0.056, path.start_of(1), 0.0299, 0.0001, 0.11})
    expect_equal(path.at(h), exact->after(h, start(), 2.0 + 30.0 * 0.004, 30.0), h);
  for (std::size_t part = 1; part <= path.parts(); ++part) {
    const double time = path.start_of(part), of_ground = 2.0 + 30.0 * (0.004 + time);
    const Vector motion = exact->after(time, start(), 2.0 + 30.0 * 0.004, 30.0);
    EXPECT_NEAR(path.ground_at(part), of_ground, 1e-12);
    expect_equal(path.motion(part), motion, time);
  }
}

// The step has at least two parts where it has two pieces, so that it is looked at inside.
TEST_F(LinearPathTest, IsKnownInside) {
  LinearPath path{count};
  for (const auto& [length, parts] : {std::pair{0.5, 1},
                                      {1.0, 1},
                                      {2.0, 2},
                                      {3.0, 3},
                                      {4.0, 2},
                                      {7.0, 4},
                                      {8.0, 2},
                                      {16.0, 2},
                                      {31.0, 6},
                                      {32.0, 4}}) {
    path.begin(*system, model.trial(), step_of(0.0, length * piece));
    EXPECT_EQ(path.parts(), static_cast<std::size_t>(parts)) << length;
  }
}

// A path over samples follows the bends of the ground's acceleration.
TEST_F(LinearPathTest, FollowsTheSamplesOfTheGround) {
  const std::vector<double> samples{0.0, 2.0, -1.0, 3.0, 1.0, 0.5, -2.0, -2.5, 0.3};
  const GroundMotion motion{"to and fro", piece, samples};
  StepTask whole{.length = 8 * piece, .end_time = 8 * piece, .ground_acceleration = {samples.back(), 0.0}};
  whole.ground.emplace(motion, 0.0, whole.length);
  LinearPath path{count};
  path.begin(*system, model.trial(), whole);
  ASSERT_EQ(path.parts(), 2U);
  EXPECT_NEAR(path.ground_at(1), samples[4], 1e-12);
  Vector at_sample = start();
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    const double time = static_cast<double>(k) * piece, slope = (samples[k + 1] - samples[k]) / piece;
    const Vector middle = exact->after(0.4 * piece, at_sample, samples[k], slope);
    expect_equal(path.at(time + 0.4 * piece), middle, time);
    at_sample = exact->after(piece, at_sample, samples[k], slope);
    expect_equal(path.at(time + piece), at_sample, time);
    at_sample.conservativeResize(2 * count);
  }
}

}  // namespace
}  // namespace moat
