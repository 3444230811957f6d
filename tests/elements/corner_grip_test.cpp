// Coulomb friction of a corner over steps of any length: against fine steps, and its tangents.
#include "elements/block/corner_grip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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
    EXPECT_NEAR((force(h, 0.0).force - force(-h, 0.0).force) / (2.0 * h), at.stiffness(friction),
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

}  // namespace
}  // namespace moat
