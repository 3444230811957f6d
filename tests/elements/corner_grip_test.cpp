// Coulomb friction of a corner over steps of any length: against fine steps, and its tangents.
#include "elements/block/corner_grip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "elements/block/corner_grips.hpp"

namespace moat {
namespace {

constexpr ContactFriction friction{0.4, 3e8};

// A contact of 0.1 s under a half sine of 5 MN, while the corner slides, sticks, and slides back.
double path_at(double t) { return 0.02 * std::sin(25.0 * t + 0.3); }
double rate_at(double t) { return 0.5 * std::cos(25.0 * t + 0.3); }
double normal_at(double t) { return 5e6 * std::sin(31.0 * t); }
double normal_rate_at(double t) { return 5e6 * 31.0 * std::cos(31.0 * t); }

CornerGrip follow(int steps, double until = 0.1) {
  CornerGrip start;
  start.path = start.slip = path_at(0.0);
  start.rate = rate_at(0.0);
  const double h = until / steps;
  for (int i = 1; i <= steps; ++i) {
    const double t = i * h;
    CornerGrip now;
    now.path = path_at(t);
    now.rate = rate_at(t);
    now.follow(start, h, friction, normal_at(t));
    now.find_rates(friction, normal_rate_at(t), 0.0);
    start = now;
  }
  return start;
}

TEST(CornerGrip, CoarseStepsEndAtTheForceOfFineOnes) {
  // It slides until 0.051 s, then sticks, and slides back at 0.095 s.
  for (const double until : {0.02, 0.04, 0.06, 0.08, 0.095}) {
    const CornerGrip fine = follow(100000, until);
    const double limit = friction.coefficient * 5e6;
    for (const int steps : {24, 37, 53})
      EXPECT_NEAR(follow(steps, until).force, fine.force, 2e-4 * limit) << until << " " << steps;
    EXPECT_LE(std::abs(fine.force), fine.limit * (1.0 + 1e-12));
  }
  EXPECT_FALSE(follow(1000, 0.06).slides());
  EXPECT_TRUE(follow(1000, 0.095).slides());
  EXPECT_EQ(follow(1000, 0.095).sense, -1.0);
}

TEST(CornerGrip, TangentsAreTheDerivatives) {
  std::mt19937 random{2};
  std::uniform_real_distribution<> part{-1.0, 1.0};
  int mixed = 0;
  for (int i = 0; i < 2000; ++i) {
    CornerGrip start;
    start.path = 0.01 * part(random);
    start.rate = part(random);
    start.limit = 1e6 * (1.0 + part(random));
    start.limit_rate = 1e8 * part(random);
    const double sense = part(random) > 0.0 ? 1.0 : -1.0;
    start.slip = start.path - (i % 2 == 0 ? sense : part(random)) * start.limit / friction.tangential_stiffness;
    constexpr double step = 0.002;
    const double path = start.path + 0.003 * part(random), normal = 2.5e6 * (1.0 + part(random));
    const auto force = [&](double by, double by_force) {
      CornerGrip now;
      now.path = path + by;
      now.follow(start, step, friction, normal + by_force);
      return now;
    };
    const CornerGrip at = force(0.0, 0.0);
    mixed += at.follows > 0.0 && at.follows < 1.0 ? 1 : 0;
    constexpr double h = 1e-9, dn = 0.1;
    EXPECT_NEAR((force(h, 0.0).force - force(-h, 0.0).force) / (2.0 * h), at.stiffness,
                1e-3 * friction.tangential_stiffness);
    EXPECT_NEAR((force(0.0, dn).force - force(0.0, -dn).force) / (2.0 * dn),
                at.follows * at.sense * friction.coefficient, 1e-3);
    EXPECT_LE(std::abs(at.force), at.limit * (1.0 + 1e-12));
  }
  EXPECT_GT(mixed, 100);
}

TEST(CornerGrip, BeginOfSlidingIsWhereTheForceMeetsItsLimit) {
  // Sticking at a constant rate under a constant limit.
  CornerGrip start;
  start.limit = 1e6;
  start.rate = 1.0;
  CornerGrip now;
  now.path = 0.01;
  now.rate = 1.0;
  now.follow(start, 0.01, friction, 1e6 / friction.coefficient);
  now.find_rates(friction, 0.0, 0.0);
  EXPECT_TRUE(now.begins_to_slide(start));
  EXPECT_NEAR(now.slide_begin(start, 0.01, friction), 1e6 / friction.tangential_stiffness / 0.01, 1e-9);
  // It goes on sliding: no begin.
  CornerGrip later;
  later.path = 0.02;
  later.rate = 1.0;
  later.follow(now, 0.01, friction, 1e6 / friction.coefficient);
  EXPECT_TRUE(std::isnan(later.slide_begin(now, 0.01, friction)));
  // The same instant again: its rates stay those of sliding, unless the limit rose.
  for (const double factor : {1.0, 0.5, 1.1}) {
    CornerGrip again = now;
    again.follow(now, 0.0, friction, factor * 1e6 / friction.coefficient);
    EXPECT_EQ(again.slides(), factor <= 1.0);
    EXPECT_NEAR(again.force, std::min(factor, 1.0) * 1e6, 1e-3);
    EXPECT_FALSE(again.begins_to_slide(now));
  }
  // One way and back in the same step: bound to the limit at the end.
  CornerGrip back;
  back.path = -0.03;
  back.follow(later, 0.01, friction, 1e6 / friction.coefficient);
  EXPECT_DOUBLE_EQ(back.force, -1e6);
  EXPECT_EQ(back.sense, -1.0);
}

// A spring that follows a Hertz contact: k_t = 0.8 x 1.5 k sqrt(d).
constexpr ContactFriction following{1.0, 0.0, 0.8};
constexpr double hertz = 1e9;  // N/m^1.5

ElasticNormal hertz_at(double d, double rate) {
  return {d, rate, hertz * d * std::sqrt(d), 1.5 * hertz * std::sqrt(d), 0.75 * hertz / std::sqrt(d)};
}

// A corner and its energy, moved in steps of `h` s under a normal force so large that it sticks.
struct Sticking {
  CornerGrip grip{};
  CornerGripEnergy energy{};

  void move(double path, double rate, double d, double d_rate, double h = 1e-3, double normal_force = 1e12) {
    CornerGrip now;
    now.path = path;
    now.rate = rate;
    now.follow(grip, h, following, normal_force, hertz_at(d, d_rate));
    now.find_rates(following, 0.0, 0.0);
    energy.add_step(grip, now, h, WorkRule::mean_force);
    grip = now;
  }
};

TEST(CornerGrip, SpringThatGrowsKeepsItsForceAndOneThatFallsItsStretch) {
  for (const int steps : {1, 7, 100}) {
    Sticking corner;
    // From touch on, u_t = d/2: dF_t = 0.8 dF_e/2, exactly.
    for (int i = 1; i <= steps; ++i) corner.move(0.5e-4 * i / steps, 0.0, 1e-4 * i / steps, 0.0);
    EXPECT_NEAR(corner.grip.force / (0.4 * hertz * 1e-6), 1.0, 1e-12) << steps;
    const double spring = 1.2 * hertz * 1e-2;
    EXPECT_NEAR(corner.grip.spring / spring, 1.0, 1e-14);
    // The force falls with the root of d, and the same stretch gives up its energy.
    const double force = corner.grip.force, stored = corner.grip.stored(), lost = corner.energy.friction;
    corner.move(0.5e-4, 0.0, 0.25e-4, 0.0);
    EXPECT_NEAR(corner.grip.force / (0.5 * force), 1.0, 1e-12);
    EXPECT_NEAR((corner.energy.friction - lost) / (0.5 * stored), 1.0, 1e-9);
    // It keeps this force where the contact closes again.
    corner.move(0.5e-4, 0.0, 1e-4, 0.0);
    EXPECT_NEAR(corner.grip.force / (0.5 * force), 1.0, 1e-12);
    EXPECT_NEAR(corner.grip.stored() / (0.25 * stored), 1.0, 1e-12);
  }
}

TEST(CornerGrip, SpringThatFollowsNeverGainsEnergy) {
  std::mt19937 random{5};
  std::uniform_real_distribution<> part{-1.0, 1.0};
  for (int run = 0; run < 50; ++run) {
    Sticking corner;
    const double a = part(random), b = part(random), phase = 3.0 * part(random);
    const int steps = 400;
    double lost = 0.0, largest = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      corner.move(1e-4 * (a * std::sin(9.0 * t + phase) + b * std::cos(23.0 * t)), 0.0,
                  1e-4 * (1.02 - std::cos(31.0 * t)), 0.0);
      largest = std::max(largest, corner.grip.stored());
      EXPECT_GE(corner.energy.friction, lost - 1e-3 * largest);
      lost = std::max(lost, corner.energy.friction);
      EXPECT_NEAR(corner.energy.work, corner.energy.friction + corner.grip.stored(), 1e-12 * (lost + largest));
    }
    EXPECT_GT(lost, 0.0);
  }
}

TEST(CornerGrip, SpringThatFollowsEndsAtTheForceOfFineSteps) {
  // A half sine of indentation in 0.1 s, while the corner slides, sticks, and slides back.
  const auto follow_to = [](int steps, double until) {
    CornerGrip start;
    start.path = start.slip = path_at(0.0);
    start.rate = rate_at(0.0);
    const double h = until / steps;
    for (int i = 1; i <= steps; ++i) {
      const double t = i * h, d = 0.03 * std::sin(31.0 * t), d_rate = 0.93 * std::cos(31.0 * t);
      const ElasticNormal elastic = hertz_at(d, d_rate);
      CornerGrip now;
      now.path = path_at(t);
      now.rate = rate_at(t);
      now.follow(start, h, {0.4, 0.0, 0.8}, elastic.force, elastic);
      now.find_rates({0.4, 0.0, 0.8}, elastic.stiffness * d_rate, 0.0);
      start = now;
    }
    return start;
  };
  const double limit = 0.4 * hertz * std::pow(0.03, 1.5);
  for (const double until : {0.02, 0.04, 0.06, 0.08, 0.095}) {
    const CornerGrip fine = follow_to(100000, until);
    for (const int steps : {48, 75, 107}) EXPECT_NEAR(follow_to(steps, until).force, fine.force, 2e-3 * limit) << until;
    EXPECT_LE(std::abs(fine.force), fine.limit * (1.0 + 1e-12));
  }
}

TEST(CornerGrip, TangentsOfASpringThatFollowsAreTheDerivatives) {
  for (const double deeper : {1e-5, -1e-5}) {
    Sticking corner;
    corner.move(3e-5, 0.0, 1e-4, 0.0);
    const CornerGrip start = corner.grip;
    const auto force = [&](double path, double d) {
      CornerGrip now;
      now.path = 3.2e-5 + path;
      now.follow(start, 1e-3, following, 1e12, hertz_at(1e-4 + deeper + d, 0.0));
      return now;
    };
    const CornerGrip at = force(0.0, 0.0);
    constexpr double h = 1e-10;
    EXPECT_NEAR((force(h, 0.0).force - force(-h, 0.0).force) / (2.0 * h) / at.stiffness, 1.0, 1e-6);
    EXPECT_NEAR((force(0.0, h).force - force(0.0, -h).force) / (2.0 * h), at.by_indentation,
                1e-5 * std::abs(at.by_indentation));
    EXPECT_NE(at.by_indentation, 0.0);
  }
}

}  // namespace
}  // namespace moat
