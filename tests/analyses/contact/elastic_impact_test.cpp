// A free mass against a wall, elastic Hertz contact: closed form.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/contact/gap.hpp"
#include "materials/impact/hertz_damp.hpp"

namespace moat {
namespace {

using namespace units;
using testing::order;
using testing::still_ground;

constexpr double mass = 550e3, stiffness = 2.95e9, speed = 0.4;
const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
// 2 * integral of ds / sqrt(1 - s^2.5) over 0..1 = 4 sqrt(pi) Gamma(0.4) / (5 Gamma(0.9)) times depth / speed.
const double duration = 0.8 * std::sqrt(3.14159265358979323846) * std::tgamma(0.4) / std::tgamma(0.9) * depth / speed;

// A free mass that reaches the wall on its right, `clearance` away, at `speed`.
Model free_mass(double restitution, Length clearance) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass * kg, .initial_velocity = speed * m / s});
  add(model, Gap<HertzDamp>{.name = "wall",
                            .left = body,
                            .right = ground,
                            .clearance = clearance,
                            .law = {.stiffness = stiffness * N / m_3_2, .restitution = restitution}});
  return model;
}

struct Rebound {
  Impact impact;
  double speed;  // away from the wall, of the whole analysis' end
};

Rebound impact(double restitution, double step, double clearance = 0.0123) {
  Model model = free_mass(restitution, clearance * m);
  const CaseResult result = run_case(model, still_ground(1 * s, 1 * s), {.transient = {.step = step * s}});
  EXPECT_EQ(result.impacts.size(), 1u);
  return {result.impacts.front(), -model.state().velocity[0]};
}

TEST(ElasticImpact, TheConstantOfTheDurationIsTheOneQuoted) { EXPECT_NEAR(duration / (depth / speed), 2.94328, 5e-6); }

TEST(ElasticImpact, DurationDepthAndForceConvergeToTheClosedForm) {
  const auto errors = [](double steps_per_contact) {
    const Rebound rebound = impact(1.0, duration / steps_per_contact);
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

TEST(ElasticImpact, ReboundsWithTheSpeedOfItsApproach) {
  const Rebound rebound = impact(1.0, duration / 400.0);
  EXPECT_NEAR(rebound.impact.start, 0.0123 / speed, 1e-12 / speed);
  EXPECT_NEAR(rebound.impact.approach_speed, speed, 1e-12);
  EXPECT_NEAR(rebound.impact.rebound_ratio, 1.0, 1e-5);
  EXPECT_NEAR(rebound.speed / speed, 1.0, 1e-5);
}

TEST(ElasticImpact, DampedReboundHasTheLawsOwnRestitution) {
  // ln((1 + z)/(1 - z e)) = z (1 + e) with z = 3/4 (1 - 0.65^2), solved by bisection.
  const double z = 0.75 * (1.0 - 0.65 * 0.65);
  double low = 0.1, high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double e = 0.5 * (low + high);
    (std::log((1.0 + z) / (1.0 - z * e)) < z * (1.0 + e) ? low : high) = e;
  }
  EXPECT_NEAR(low, 0.775, 5e-4);
  const double coarse = std::abs(impact(0.65, duration / 50.0).impact.rebound_ratio - low);
  const double fine = std::abs(impact(0.65, duration / 200.0).impact.rebound_ratio - low);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, 6e-5);
  EXPECT_NEAR(order(coarse, fine) / 2.0, 2.0, 0.3);
}

TEST(ElasticImpact, ThePhaseOfArrivalWithinAStepDoesNotMatter) {
  const double step = duration / 50.0;
  for (const double restitution : {1.0, 0.65, 0.3}) {
    double slowest = 1e300, fastest = 0.0;
    for (int phase = 0; phase < 100; ++phase) {
      // From the wall reached at the end of the tenth step to just before the eleventh.
      const double rebound = impact(restitution, step, speed * step * (10.0 + phase / 100.0)).speed;
      slowest = std::min(slowest, rebound);
      fastest = std::max(fastest, rebound);
    }
    EXPECT_LT((fastest - slowest) / speed, 1e-3) << restitution;
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
  const CaseResult result = run_case(model, still_ground(1 * s), {.transient = {.step = 0.2 * ms}});
  ASSERT_EQ(result.impacts.size(), 1u);
  EXPECT_NEAR(model.state().velocity[0], 0.0, 1e-5 * speed);
  EXPECT_NEAR(model.state().velocity[1], speed, 1e-5 * speed);
  // Half the mass is effective: depth and duration shrink with m^0.4.
  EXPECT_NEAR(result.impacts.front().largest_indentation, depth * std::pow(0.5, 0.4), 1e-4 * depth);
  EXPECT_NEAR(result.impacts.front().duration, duration * std::pow(0.5, 0.4), 1e-4 * duration);
}

}  // namespace
}  // namespace moat
