// The table of impacts, filled by real analyses.

#include "output/recorders/impact_recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analyses/time_history/transient.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;
using testing::still_ground;

constexpr double mass = 550e3, stiffness = 2.95e9;

HertzDamp law_of(double restitution) { return {.stiffness = stiffness * N / m_3_2, .restitution = restitution}; }

Gap<HertzDamp> wall(const std::string& name, NodeId left, NodeId right, double restitution) {
  return {
      .name = name, .place = "walls", .left = left, .right = right, .clearance = 2 * cm, .law = law_of(restitution)};
}

// With the wall on its right.
Model body_at_speed(double speed, double restitution) {
  return testing::body_before_wall(law_of(restitution), mass, speed, 0.02);
}

std::vector<Impact> impacts(const Model& model, double end, double step = 1e-3) {
  ImpactRecorder recorder;
  Transient analysis{model, still_ground(end * s, end * s), {.step = step * s}};
  analysis.attach(recorder);
  analysis.run();
  return recorder.impacts();
}

TEST(ImpactRecorder, ListsTouchesOfAnElasticBodyBetweenTwoWalls) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass * kg, .initial_velocity = 0.4 * m / s});
  add(model, wall("left wall", ground, body, 1.0));
  add(model, wall("right wall", body, ground, 1.0));
  const std::vector<Impact> found = impacts(model, 1.1, 2e-4);

  const double depth = std::pow(1.25 * mass * 0.16 / stiffness, 0.4), duration = 2.9432750 * depth / 0.4;
  ASSERT_GE(found.size(), 4u);
  double start = 0.02 / 0.4;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].where, i % 2 == 0 ? "right wall" : "left wall");
    EXPECT_NEAR(found[i].start, start, 1e-4 * static_cast<double>(i + 1)) << i;
    EXPECT_NEAR(found[i].approach_speed, 0.4, 1e-4) << i;
    if (i + 1 == found.size()) break;
    EXPECT_NEAR(found[i].duration, duration, 1e-4 * duration) << i;
    EXPECT_NEAR(found[i].largest_indentation, depth, 1e-4 * depth) << i;
    EXPECT_NEAR(found[i].largest_force, stiffness * std::pow(depth, 1.5), 1e-4 * stiffness * std::pow(depth, 1.5)) << i;
    EXPECT_NEAR(found[i].rebound_ratio, 1.0, 1e-4) << i;
    start += duration + 0.04 / 0.4;  // back across both gaps
  }
}

TEST(ImpactRecorder, AContactThatLastsAtTheEndHasNoReboundRatio) {
  const std::vector<Impact> found = impacts(body_at_speed(0.4, 0.65), 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].duration, 0.05, 1e-9);
  EXPECT_GT(found[0].largest_indentation, 0.01);
  EXPECT_GT(found[0].largest_force, 1e6);
  EXPECT_TRUE(std::isnan(found[0].rebound_ratio));
}

TEST(ImpactRecorder, AContactThatLastsFromTheStartIsListed) {
  const Model model = body_at_speed(0.4, 0.65);
  Transient first{model, still_ground(0.1 * s, 0.1 * s), {.step = 1 * ms}};
  first.run();
  ImpactRecorder recorder;
  Transient second{model, still_ground(1 * s, 1 * s), first.state(), {.step = 1 * ms}};
  second.attach(recorder);
  second.run();
  const std::vector<Impact>& found = recorder.impacts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].start, 0.1, 1e-12);
  EXPECT_NEAR(found[0].approach_speed, 0.4, 1e-9);  // that of the touch, before this analysis
  EXPECT_GT(found[0].rebound_ratio, 0.7);
  EXPECT_LT(found[0].rebound_ratio, 0.8);
}

// The one impact of a free tonne on a wall; it starts `overlap` beyond it or, if negative, before it.
template <class Law>
Impact impact_on_wall(const Law& law, double speed, double overlap, double end = 0.5) {
  Model model;
  const NodeId body = add(model, Node{.name = "body",
                                      .mass = 1 * tonne,
                                      .initial_displacement = 1 * cm + overlap * m,
                                      .initial_velocity = speed * m / s,
                                      .free = true});
  add(model, Gap<Law>{.name = "wall", .left = body, .right = ground, .clearance = 1 * cm, .law = law});
  ImpactRecorder recorder;
  Transient analysis{model, still_ground(end * s, end / 100.0 * s), {}};
  analysis.attach(recorder);
  analysis.run();
  EXPECT_EQ(recorder.impacts().size(), 1u);
  return recorder.impacts().empty() ? Impact{} : recorder.impacts().front();
}

TEST(ImpactRecorder, ASlowTouchHasItsTrueSpeedAndRebound) {
  const LinearElastic elastic{.stiffness = 1e8 * N / m};
  const ExactKelvin kelvin{.stiffness = 1e8 * N / m, .restitution = 0.5};
  const ExactHertzDamp hertz{.stiffness = 1e9 * N / m_3_2, .restitution = 0.5};
  for (const double speed : {1e-3, 5e-5, 1e-5, 1e-6}) {
    SCOPED_TRACE(speed);
    const auto expect = [&](const Impact& impact, double restitution) {
      EXPECT_NEAR(impact.approach_speed, speed, 1e-9 * speed);
      EXPECT_NEAR(impact.rebound_ratio, restitution, 1e-3);  // default steps in contact
      EXPECT_NEAR(impact.restitution, restitution, 1e-7);
    };
    const double before = -0.1 * speed;
    expect(impact_on_wall(elastic, speed, before), 1.0);
    expect(impact_on_wall(kelvin, speed, before), 0.5);
    // Below 1e-4 m/s the law divides by that, so that its damping is that of a factor z v0/1e-4.
    const double factor = damping_factor_of_viscous_hertz(0.5) * std::min(speed / 1e-4, 1.0);
    expect(impact_on_wall(hertz, speed, before), restitution_of_viscous_hertz(factor));
  }
}

TEST(ImpactRecorder, AContactClosedAtTheStartHasNoApproach) {
  for (const double speed : {0.0, 1.0, -1.0}) {
    const Impact impact = impact_on_wall(LinearElastic{.stiffness = 1e8 * N / m}, speed, 0.001);
    EXPECT_EQ(impact.start, 0.0);
    EXPECT_EQ(impact.approach_speed, speed);
    EXPECT_TRUE(std::isnan(impact.rebound_ratio)) << impact.rebound_ratio;
    EXPECT_TRUE(std::isnan(impact.restitution)) << impact.restitution;
  }
}

TEST(ImpactRecorder, AContactDrivenAfterASlowTouchHasNoReboundRatio) {
  // Newton's cradle: the second contact closes when the first has hardly begun to push, and opens with almost all of
  // the speed.
  Model model;
  const NodeId first = add(model, Node{.name = "first", .mass = 1 * tonne, .initial_velocity = 1 * m / s});
  const NodeId second = add(model, Node{.name = "second", .mass = 1 * tonne, .free = true});
  const NodeId third = add(model, Node{.name = "third", .mass = 1 * tonne, .free = true});
  const LinearElastic law{.stiffness = 1e8 * N / m};
  add(model, Gap<LinearElastic>{.name = "1-2", .left = first, .right = second, .clearance = 1 * cm, .law = law});
  add(model, Gap<LinearElastic>{.name = "2-3", .left = second, .right = third, .clearance = 1e-9 * m, .law = law});
  const std::vector<Impact> found = impacts(model, 0.1, 1e-5);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_GT(found[1].approach_speed, 0.0);
  EXPECT_LT(found[1].approach_speed, 1e-3);
  EXPECT_GT(found[1].duration, 0.0);
  EXPECT_TRUE(std::isnan(found[1].rebound_ratio)) << found[1].rebound_ratio;
  EXPECT_NEAR(found[1].restitution, 1.0, 1e-7);
}

TEST(ImpactRecorder, ListsOverlappingContactsInOrderOfTouch) {
  Model model;
  const NodeId early = add(model, Node{.name = "early", .mass = mass * kg, .initial_velocity = 0.41 * m / s});
  const NodeId late = add(model, Node{.name = "late", .mass = mass * kg, .initial_velocity = 0.40 * m / s});
  add(model, wall("of late", late, ground, 1.0));
  add(model, wall("of early", early, ground, 0.65));
  const std::vector<Impact> found = impacts(model, 1.0);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].where, "of early");
  EXPECT_EQ(found[1].where, "of late");
  EXPECT_LT(found[1].start, found[0].start + found[0].duration);
  EXPECT_NEAR(found[0].rebound_ratio, 0.775, 2e-3);
  EXPECT_NEAR(found[1].rebound_ratio, 1.0, 1e-3);

  // Each has the peaks it has alone: the events of the other do not make it forget.
  for (const Impact& together : found) {
    const bool is_early = together.where == "of early";
    const std::vector<Impact> expected = impacts(is_early ? body_at_speed(0.41, 0.65) : body_at_speed(0.40, 1.0), 1.0);
    ASSERT_EQ(expected.size(), 1u);
    EXPECT_NEAR(together.largest_force, expected[0].largest_force, 1e-4 * expected[0].largest_force);
    EXPECT_NEAR(together.largest_indentation, expected[0].largest_indentation, 1e-4 * expected[0].largest_indentation);
  }
}

TEST(ImpactRecorder, TheLargestForceIsThatOfThePeaks) {
  // Both ask the law for its force where the cubic through the forces at the ends of a step turns.
  const Model model = body_at_speed(0.4, 0.65);
  ImpactRecorder recorder;
  PeakRecorder peaks{model};
  Transient analysis{model, still_ground(1 * s, 1 * s), {.step = 4 * ms}};
  analysis.attach(recorder);
  analysis.attach(peaks);
  analysis.run();
  ASSERT_EQ(recorder.impacts().size(), 1u);
  const std::vector<Peak> found = peaks.peaks();
  const auto force = std::ranges::find(found, "impact_force", &Peak::quantity);
  ASSERT_NE(force, found.end());
  EXPECT_EQ(recorder.impacts()[0].largest_force, force->value);
}

TEST(ImpactRecorder, NothingTouchesNothingIsListed) { EXPECT_TRUE(impacts(body_at_speed(0.01, 0.65), 1.0).empty()); }

}  // namespace
}  // namespace moat
