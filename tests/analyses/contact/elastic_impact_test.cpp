// A free mass against a wall, elastic Hertz contact: closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis_testing.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double mass = 550e3, stiffness = 2.95e9, speed = 0.4;
const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
// 2 * integral of ds / sqrt(1 - s^2.5) over 0..1 = 4 sqrt(pi) Gamma(0.4) / (5 Gamma(0.9)) times depth / speed.
const double duration = 0.8 * std::sqrt(3.14159265358979323846) * std::tgamma(0.4) / std::tgamma(0.9) * depth / speed;

struct Rebound {
  Impact impact;
  double speed;  // away from the wall, of the whole analysis' end
};

Rebound impact(double step) {
  const HertzDamp elastic{.stiffness = stiffness * N / m_3_2, .restitution = 1.0};
  Model model = testing::body_before_wall(elastic, mass, speed, 0.0123);
  const auto [result, state] = run_to_end(model, still_ground(1 * s, 1 * s), {.transient = {.step = step * s}});
  EXPECT_EQ(result.impacts.size(), 1u);
  return {result.impacts.front(), -state.velocity(NodeId{0})};
}

TEST(ElasticImpact, DurationDepthAndForceConvergeToTheClosedForm) {
  const auto errors = [](double steps_per_contact) {
    const Rebound rebound = impact(duration / steps_per_contact);
    return std::vector<double>{std::abs(rebound.impact.duration / duration - 1.0),
                               std::abs(rebound.impact.largest_indentation / depth - 1.0),
                               std::abs(rebound.impact.largest_force / (stiffness * std::pow(depth, 1.5)) - 1.0)};
  };
  const auto coarse = errors(100.0), fine = errors(400.0);
  const double needed[] = {2e-5, 2e-5, 2e-5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(fine[i], needed[i]) << i;
    // Second order: a quarter of the step, a sixteenth of the error; the peaks' own interpolation adds scatter.
    EXPECT_LT(fine[i], coarse[i] / 8.0 + 1e-7) << i;
  }
}

TEST(ElasticImpact, TwoFreeBodiesExchangeTheirVelocities) {
  // Equal masses, elastic: the moving one stops, the other takes its speed.
  Model model;
  const NodeId left = add(model, Node{.name = "left", .mass = mass * kg, .initial_velocity = speed * m / s});
  const NodeId right = add(model, Node{.name = "right", .mass = mass * kg, .free = true});
  add(model, Gap<HertzDamp>{.name = "gap",
                            .left = left,
                            .right = right,
                            .clearance = 1 * cm,
                            .law = {.stiffness = stiffness * N / m_3_2, .restitution = 1.0}});
  const auto [result, state] = run_to_end(model, still_ground(1 * s), {.transient = {.step = 0.2 * ms}});
  ASSERT_EQ(result.impacts.size(), 1u);
  EXPECT_NEAR(state.velocity(left), 0.0, 1e-5 * speed);
  EXPECT_NEAR(state.velocity(right), speed, 1e-5 * speed);
  // Half the mass is effective: depth and duration shrink with m^0.4.
  EXPECT_NEAR(result.impacts.front().largest_indentation, depth * std::pow(0.5, 0.4), 1e-4 * depth);
  EXPECT_NEAR(result.impacts.front().duration, duration * std::pow(0.5, 0.4), 1e-4 * duration);
}

}  // namespace
}  // namespace moat
