#include "analyses/linear_system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "elements/spring.hpp"
#include "exponential_motion.hpp"
#include "materials/linear.hpp"
#include "message_of.hpp"
#include "model/model.hpp"

namespace moat {
namespace {

using namespace units;

// A chain of bodies between two walls.
Model chain(const std::vector<double>& masses, double stiffness = 4e4) {
  Model model;
  NodeId below = ground;
  for (std::size_t i = 0; i <= masses.size(); ++i) {
    const NodeId above =
        i == masses.size() ? ground : add(model, Node{.name = "body " + std::to_string(i), .mass = masses[i] * kg});
    const auto number = static_cast<double>(i);
    add(model, Spring<Linear>{.name = "spring " + std::to_string(i),
                              .lower = below,
                              .upper = above,
                              .law = {.stiffness = (1.0 + 0.2 * number) * stiffness * N / m,
                                      .damping = (200.0 + 50.0 * number) * N * s / m}});
    below = above;
  }
  model.prepare();
  return model;
}

std::vector<double> masses_of(std::size_t count) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < count; ++i) masses.push_back(100.0 + 30.0 * static_cast<double>(i));
  return masses;
}

LinearSystem system_of(const Model& model, double longest_step) {
  const testing::Tangents tangents{model};
  return {tangents.stiffness, tangents.damping, model.masses(), longest_step};
}

// The system of a chain, its motion by the exponential, and a start of it: displacements, then velocities.
struct MovingChain {
  Model model;
  LinearSystem system;
  testing::ExponentialMotion exact;
  Vector start;

  MovingChain(const std::vector<double>& masses, double longest_step)
      : model{chain(masses)},
        system{system_of(model, longest_step)},
        exact{model, testing::Tangents{model}, Vector::Zero(model.degrees_of_freedom())} {
    const int count = model.degrees_of_freedom();
    start.resize(2 * count);
    for (int i = 0; i < count; ++i) {
      exact.offset[i] = 0.7 - 0.2 * i;
      start[i] = 0.01 * std::sin(1.0 + i);
      start[count + i] = 0.4 * std::cos(2.0 + 3.0 * i);
    }
    system.set_offset(exact.offset);
  }
  [[nodiscard]] Vector room_for_result() const {
    return Vector::Zero(LinearSystem::result_size(model.degrees_of_freedom()));
  }
};

// Each part of the motion to a share of its largest entry.
void expect_equal(const Vector& found, const Vector& exact) {
  const Eigen::Index count = exact.size() / 4;
  for (Eigen::Index part = 0; part < 4; ++part) {
    const Vector of_part = exact.segment(part * count, count);
    const double allowed = 1e-12 * of_part.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < count; ++i) EXPECT_NEAR(found[part * count + i], of_part[i], allowed) << part << i;
  }
}

// 1, 2, 4 and 8 steps at once, while the ground's acceleration bends at the end of each.
void expect_to_advance_as_the_exponential(const MovingChain& chain) {
  constexpr std::array ground{2.3, -1.0, 0.4, 3.0, 3.0, -2.0, 0.0, 1.0, -0.7};
  const double h = chain.system.step();
  Vector end = chain.start, found = chain.room_for_result();
  std::size_t steps = 0;
  for (std::size_t doublings = 0; (std::size_t{1} << doublings) <= LinearSystem::most_steps_at_once; ++doublings) {
    SCOPED_TRACE(doublings);
    for (; steps < (std::size_t{1} << doublings); ++steps)
      end = chain.exact.after(h, end, ground.at(steps), (ground.at(steps + 1) - ground.at(steps)) / h);
    chain.system.advance(doublings, chain.start.data(), ground.data(), found.data());
    expect_equal(found, end);
  }
}

TEST(LinearSystem, AdvancesAsTheExponential) {
  for (const std::size_t count : {1u, 2u, 3u, 5u, 8u, 11u}) {
    SCOPED_TRACE(count);
    expect_to_advance_as_the_exponential({masses_of(count), 0.04});
  }
}

// Coefficients of a light body are larger than its motion where it hangs on heavy ones.
TEST(LinearSystem, KeepsItsDigitsBetweenLightAndHeavyBodies) {
  const MovingChain chain{{1e6, 1.0, 1e6, 1.0}, 0.01};
  constexpr std::array ground{2.3, -1.0};
  const double h = chain.system.step();
  Vector found = chain.room_for_result();
  chain.system.advance(0, chain.start.data(), ground.data(), found.data());
  expect_equal(found, chain.exact.after(h, chain.start, ground[0], (ground[1] - ground[0]) / h));
}

// A series gives the motion at every time in a step.
TEST(LinearSystem, TheSeriesIsTheExponential) {
  constexpr double ground = 2.3, slope = -17.0;
  for (const std::size_t count : {1u, 3u, 8u}) {
    SCOPED_TRACE(count);
    const MovingChain chain{masses_of(count), 0.02};
    LinearMotionSeries series{chain.model.degrees_of_freedom()};
    Vector found = chain.room_for_result();
    for (const double longest : {1.0, 0.6, 0.1, 1e-6})
      for (const double share : {1e-6, 0.1, 0.6, 1.0}) {
        if (share > longest) continue;
        SCOPED_TRACE(longest);
        SCOPED_TRACE(share);
        series.expand(chain.system, chain.start.data(), ground, slope, longest * chain.system.step());
        const double h = share * chain.system.step();
        series.evaluate(h, found.data());
        expect_equal(found, chain.exact.after(h, chain.start, ground, slope));
      }
    series.evaluate(0.0, found.data());
    for (Eigen::Index i = 0; i < chain.start.size(); ++i) EXPECT_DOUBLE_EQ(found[i], chain.start[i]) << i;
  }
}

TEST(LinearSystem, HalvesItsStepForTheFastestVibration) {
  const Model model = chain({100.0});
  // sqrt(4e4 (1 + 1.2) / 100 kg) is 29.7 1/s: 0.02 s is just too long for a half.
  EXPECT_DOUBLE_EQ(system_of(model, 0.016).step(), 0.016);
  EXPECT_DOUBLE_EQ(system_of(model, 0.02).step(), 0.01);
  EXPECT_DOUBLE_EQ(system_of(model, 1.0).step(), 1.0 / 64.0);
  const auto too_stiff = [] { [[maybe_unused]] const LinearSystem system = system_of(chain({100.0}, 4e17), 1.0); };
  EXPECT_NE(testing::message_of(too_stiff).find("fastest eigenvalue"), std::string::npos);
}

TEST(LinearSystem, KnowsItsTangents) {
  const Model model = chain(masses_of(3));
  const testing::Tangents tangents{model}, stiffer{chain(masses_of(3), 5e4)};
  const LinearSystem system = system_of(model, 0.01);
  EXPECT_TRUE(system.is_of(tangents.stiffness, tangents.damping));
  EXPECT_FALSE(system.is_of(stiffer.stiffness, tangents.damping));
  EXPECT_FALSE(system.is_of(tangents.stiffness, tangents.stiffness));
}

}  // namespace
}  // namespace moat
