// A path of several pieces is the motion that one series describes.
#include "analyses/linear_path.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "elements/spring.hpp"
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
    SparseMatrix stiffness = model.pattern(), damping = model.pattern();
    model.assemble_tangent(0.0, 0.0, 1.0, stiffness);
    model.assemble_tangent(0.0, 1.0, 0.0, damping);
    system.emplace(stiffness, damping, model.masses(), piece);
    system->set_offset(Vector{{0.3, -0.2, 0.1}});
    model.trial().displacement.head(count) << 0.01, -0.02, 0.03;
    model.trial().velocity.head(count) << 0.5, 0.1, -0.4;
  }

  // (u, u', u'') after h, by one series from the start of the step.
  [[nodiscard]] std::vector<double> by_series(const StepTask& step, double h) const {
    std::vector<double> start{1.0, step.ground_acceleration_at_start.x, step.ground_jerk.x};
    for (Eigen::Index i = 0; i < count; ++i) start.push_back(model.trial().displacement[i]);
    for (Eigen::Index i = 0; i < count; ++i) start.push_back(model.trial().velocity[i]);
    LinearMotionSeries series{count};
    series.expand(*system, start.data(), step.length);
    std::vector<double> result(static_cast<std::size_t>(LinearSystem::result_size(count)));
    series.evaluate(h, result.data());
    return result;
  }

  Model model;
  std::optional<LinearSystem> system;
};

// The ground accelerates as 2 + 30 t (m/s^2). The step begins between multiples of the piece.
StepTask step_of(double start, double length) {
  return {.length = length,
          .end_time = start + length,
          .ground_acceleration = {2.0 + 30.0 * (start + length), 0.0},
          .ground_jerk = {30.0, 0.0},
          .ground_acceleration_at_start = {2.0 + 30.0 * start, 0.0},
          .start_time = start};
}

TEST_F(LinearPathTest, IsTheMotionOfOneSeriesUnderASteadySlopeOfTheGround) {
  const StepTask step = step_of(0.004, 0.033);
  LinearPath path{count};
  path.begin(*system, model.trial(), step);
  ASSERT_EQ(path.pieces(), 4U);
  EXPECT_DOUBLE_EQ(path.start_of(1), 0.006);
  EXPECT_DOUBLE_EQ(path.start_of(4), step.length);
  // Ends and insides of pieces, not in their order.
  for (const double h : {0.02, step.length, 0.001, path.start_of(2), path.start_of(1), 0.0299, 0.0001}) {
    const std::vector<double> exact = by_series(step, h);
    const double* found = path.at(h);
    for (std::size_t i = 0; i < 3 * count; ++i) EXPECT_NEAR(found[i], exact[i], 1e-10) << h << " " << i;
  }
  for (std::size_t k = 1; k < path.pieces(); ++k) {
    const std::vector<double> exact = by_series(step, path.start_of(k));
    for (Eigen::Index i = 0; i < count; ++i)
      EXPECT_NEAR(path.absolute_acceleration(k, i),
                  exact[static_cast<std::size_t>(2 * count + i)] + 2.0 + 30.0 * (0.004 + path.start_of(k)), 1e-10);
  }
}

// A path over samples is a path from sample to sample.
TEST_F(LinearPathTest, FollowsTheSamplesOfTheGround) {
  const GroundMotion motion{"to and fro", piece, {0.0, 2.0, -1.0, 3.0, 1.0}};
  StepTask whole{.length = 4 * piece, .end_time = 4 * piece, .ground_acceleration = {1.0, 0.0}};
  whole.ground.emplace(motion, 0.0, whole.length);
  LinearPath path{count};
  path.begin(*system, model.trial(), whole);
  ASSERT_EQ(path.pieces(), 4U);
  constexpr std::array samples{0.0, 2.0, -1.0, 3.0, 1.0};
  for (std::size_t k = 0; k < samples.size(); ++k) EXPECT_NEAR(path.ground_at(k), samples.at(k), 1e-12) << k;
  MotionState at_sample = model.trial();
  LinearPath single{count};
  for (std::size_t k = 0; k < path.pieces(); ++k) {
    const double start = static_cast<double>(k) * piece;
    single.begin(*system, at_sample,
                 {.length = piece,
                  .end_time = start + piece,
                  .ground_acceleration = {samples.at(k + 1), 0.0},
                  .ground_jerk = {(samples.at(k + 1) - samples.at(k)) / piece, 0.0},
                  .ground_acceleration_at_start = {samples.at(k), 0.0},
                  .start_time = start});
    const double* end = single.at(piece);
    const double* of_whole = path.at(start + piece);
    for (std::size_t i = 0; i < 3 * count; ++i) EXPECT_NEAR(of_whole[i], end[i], 1e-10) << k << " " << i;
    for (Eigen::Index i = 0; i < count; ++i) {
      at_sample.displacement[i] = end[i];
      at_sample.velocity[i] = end[count + i];
    }
  }
}

}  // namespace
}  // namespace moat
