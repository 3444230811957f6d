#include "analyses/linear_system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "elements/spring.hpp"
#include "exponential_motion.hpp"
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

// Displacements, then velocities.
Vector start_of(int count) {
  Vector start(2 * count);
  for (int i = 0; i < count; ++i) start[i] = 0.01 * std::sin(1.0 + i);
  for (int i = 0; i < count; ++i) start[count + i] = 0.4 * std::cos(2.0 + 3.0 * i);
  return start;
}

Vector offset_of(int count) {
  Vector offset(count);
  for (int i = 0; i < count; ++i) offset[i] = 0.7 - 0.2 * i;
  return offset;
}

Vector room_for(int count) { return Vector::Zero(LinearSystem::result_size(count)); }

// Each part of the motion to a share of its largest entry.
void expect_equal(const Vector& found, const Vector& exact) {
  const Eigen::Index count = exact.size() / 3;
  for (Eigen::Index part = 0; part < 3; ++part) {
    const Vector of_part = exact.segment(part * count, count);
    const double allowed = 1e-12 * of_part.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < count; ++i) EXPECT_NEAR(found[part * count + i], of_part[i], allowed) << part << i;
  }
}

// 1, 2, 4 and 8 steps at once, while the ground's acceleration bends at the end of each.
TEST(LinearSystem, AdvancesAsTheExponential) {
  constexpr std::array ground{2.3, -1.0, 0.4, 3.0, 3.0, -2.0, 0.0, 1.0, -0.7};
  for (const int count : {1, 2, 3, 5, 8, 11}) {
    SCOPED_TRACE(count);
    const Chain chain{count};
    LinearSystem system = chain.system(0.04);
    system.set_offset(offset_of(count));
    const testing::ExponentialMotion exact{chain.stiffness, chain.damping, chain.model.masses(), offset_of(count)};
    const Vector start = start_of(count);
    Vector end = start;
    std::size_t steps = 0;
    for (std::size_t doublings = 0; (std::size_t{1} << doublings) <= LinearSystem::most_steps_at_once; ++doublings) {
      SCOPED_TRACE(doublings);
      for (; steps < (std::size_t{1} << doublings); ++steps)
        end = exact.after(system.step(), end, ground.at(steps),
                          (ground.at(steps + 1) - ground.at(steps)) / system.step());
      Vector found = room_for(count);
      system.advance(doublings, start.data(), ground.data(), found.data());
      expect_equal(found, end);
    }
  }
}

// A series gives the motion at every time in a step.
TEST(LinearSystem, TheSeriesIsTheExponential) {
  constexpr double ground = 2.3, slope = -17.0;
  for (const int count : {1, 3, 8}) {
    SCOPED_TRACE(count);
    const Chain chain{count};
    LinearSystem system = chain.system(0.02);
    system.set_offset(offset_of(count));
    const testing::ExponentialMotion exact{chain.stiffness, chain.damping, chain.model.masses(), offset_of(count)};
    const Vector start = start_of(count);
    LinearMotionSeries series{count};
    series.expand(system, start.data(), ground, slope);
    Vector found = room_for(count);
    for (const double share : {1e-6, 0.1, 0.6, 1.0}) {
      const double h = share * system.step();
      series.evaluate(h, found.data());
      expect_equal(found, exact.after(h, start, ground, slope));
    }
    series.evaluate(0.0, found.data());
    for (Eigen::Index i = 0; i < start.size(); ++i) EXPECT_DOUBLE_EQ(found[i], start[i]) << i;
  }
}

// Terms of the series grow before they shrink where a light body hangs on a heavy one.
TEST(LinearSystem, KeepsItsDigitsBetweenLightAndHeavyBodies) {
  Model model;
  NodeId below = ground;
  for (int i = 0; i < 4; ++i) {
    const NodeId above = add(model, Node{.name = "body " + std::to_string(i), .mass = (i % 2 == 0 ? 1e6 : 1.0) * kg});
    add(model, Spring<Linear>{.name = "spring " + std::to_string(i),
                              .lower = below,
                              .upper = above,
                              .law = {.stiffness = 4e4 * N / m, .damping = 20.0 * N * s / m}});
    below = above;
  }
  model.prepare();
  SparseMatrix stiffness = model.pattern(), damping = model.pattern();
  model.assemble_tangent(0.0, 0.0, 1.0, stiffness);
  model.assemble_tangent(0.0, 1.0, 0.0, damping);
  const LinearSystem system{stiffness, damping, model.masses(), 0.01};
  const testing::ExponentialMotion exact{stiffness, damping, model.masses(), Vector::Zero(4)};
  constexpr std::array ground{2.3, -1.0};
  const Vector start = start_of(4);
  Vector found = room_for(4);
  system.advance(0, start.data(), ground.data(), found.data());
  expect_equal(found, exact.after(system.step(), start, ground[0], (ground[1] - ground[0]) / system.step()));
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
