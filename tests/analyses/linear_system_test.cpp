#include "analyses/linear_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "elements/spring.hpp"
#include "materials/linear.hpp"
#include "message_of.hpp"
#include "model/model.hpp"

namespace moat {
namespace {

using namespace units;

// Tangents of a chain of bodies between two walls.
struct Chain {
  Model model;
  SparseMatrix stiffness, damping;

  explicit Chain(int count, double of_stiffness = 4e4) {
    NodeId below = ground;
    for (int i = 0; i <= count; ++i) {
      const NodeId above =
          i == count ? ground : add(model, Node{.name = "body " + std::to_string(i), .mass = (100.0 + 30.0 * i) * kg});
      add(model, Spring<Linear>{.name = "spring " + std::to_string(i),
                                .lower = below,
                                .upper = above,
                                .law = {.stiffness = (1.0 + 0.2 * i) * of_stiffness * N / m,
                                        .damping = (200.0 + 50.0 * i) * N * s / m}});
      below = above;
    }
    model.prepare();
    stiffness = model.pattern();
    damping = model.pattern();
    model.assemble_tangent(0.0, 0.0, 1.0, stiffness);
    model.assemble_tangent(0.0, 1.0, 0.0, damping);
  }
  [[nodiscard]] LinearSystem system(double longest_step) const {
    return {stiffness, damping, model.masses(), longest_step};
  }
};

// 1, the ground's acceleration and slope, displacements, velocities.
std::vector<double> start_of(int count) {
  std::vector<double> start{1.0, 2.3, -17.0};
  for (int i = 0; i < count; ++i) start.push_back(0.01 * std::sin(1.0 + i));
  for (int i = 0; i < count; ++i) start.push_back(0.4 * std::cos(2.0 + 3.0 * i));
  return start;
}

std::vector<double> room_for(int count) {
  return std::vector<double>(static_cast<std::size_t>(LinearSystem::result_size(count)));
}

TEST(LinearSystem, StepsAndSeriesAgree) {
  for (const int count : {1, 2, 3, 5, 8, 11}) {
    SCOPED_TRACE(count);
    const Chain chain{count};
    LinearSystem system = chain.system(0.04);
    Vector offset(count);
    for (int i = 0; i < count; ++i) offset[i] = 0.7 - 0.2 * i;
    system.set_offset(offset);
    const std::vector<double> start = start_of(count);
    std::vector<double> by_matrix = room_for(count), by_series = room_for(count);
    system.advance(start.data(), by_matrix.data());
    LinearMotionSeries series{count};
    series.expand(system, start.data(), system.step());
    series.evaluate(system.step(), by_series.data());
    for (int i = 0; i < 3 * count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(by_matrix[k], by_series[k], 1e-12 * (1.0 + std::abs(by_series[k]))) << i;
    }
  }
}

// The sum of two steps is the series of a step of double length.
TEST(LinearSystem, TwoStepsAreOneOfDoubleLength) {
  constexpr int count = 4;
  const Chain chain{count};
  const LinearSystem system = chain.system(0.01);
  const double h = system.step();
  std::vector<double> start = start_of(count), middle = room_for(count), end = room_for(count), whole = room_for(count);
  system.advance(start.data(), middle.data());
  LinearMotionSeries series{count};
  series.expand(system, start.data(), 2.0 * h);
  series.evaluate(2.0 * h, whole.data());
  start[LinearStart::ground] += h * start[LinearStart::slope];
  std::copy_n(middle.begin(), 2 * count, start.begin() + LinearStart::motion);
  system.advance(start.data(), end.data());
  for (std::size_t i = 0; i < 3 * count; ++i) EXPECT_NEAR(end[i], whole[i], 1e-11) << i;
}

// The series obeys the equation: its acceleration is the derivative of its velocity.
TEST(LinearSystem, TheSeriesObeysItsEquation) {
  constexpr int count = 3;
  const Chain chain{count};
  const LinearSystem system = chain.system(0.02);
  const std::vector<double> start = start_of(count);
  LinearMotionSeries series{count};
  series.expand(system, start.data(), system.step());
  constexpr double little = 1e-5;
  const double h = 0.6 * system.step();
  std::vector<double> before = room_for(count), here = room_for(count), after = room_for(count);
  series.evaluate(h - little, before.data());
  series.evaluate(h, here.data());
  series.evaluate(h + little, after.data());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR((after[i] - before[i]) / (2.0 * little), here[count + i], 1e-7) << i;
    EXPECT_NEAR((after[count + i] - before[count + i]) / (2.0 * little), here[2 * count + i], 1e-5) << i;
  }
  series.evaluate(0.0, here.data());
  for (std::size_t i = 0; i < 2 * count; ++i) EXPECT_DOUBLE_EQ(here[i], start[LinearStart::motion + i]);
}

TEST(LinearSystem, HalvesItsStepForTheFastestVibration) {
  const Chain chain{1};
  // sqrt(4e4 (1 + 1.2) / 100 kg) is 29.7 1/s: 0.02 s is just too long for a half.
  EXPECT_DOUBLE_EQ(chain.system(0.016).step(), 0.016);
  EXPECT_DOUBLE_EQ(chain.system(0.02).step(), 0.01);
  EXPECT_DOUBLE_EQ(chain.system(1.0).step(), 1.0 / 64.0);
  const auto too_stiff = [] { [[maybe_unused]] const LinearSystem system = Chain{1, 4e17}.system(1.0); };
  EXPECT_NE(testing::message_of(too_stiff).find("fastest eigenvalue"), std::string::npos);
}

TEST(LinearSystem, KnowsItsTangents) {
  const Chain chain{3}, stiffer{3, 5e4};
  const LinearSystem system = chain.system(0.01);
  EXPECT_TRUE(system.is_of(chain.stiffness, chain.damping));
  EXPECT_FALSE(system.is_of(stiffer.stiffness, chain.damping));
  EXPECT_FALSE(system.is_of(chain.stiffness, chain.stiffness));
}

}  // namespace
}  // namespace moat
