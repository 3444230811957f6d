#include "motions/ground_span.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace moat {
namespace {

GroundMotion irregular_motion(double interval = 0.02) {
  std::vector<double> samples;
  for (int i = 0; i < 200; ++i) samples.push_back(std::sin(1.7 * i) + 0.8 * std::cos(0.31 * i * i) - 0.1);
  return GroundMotion{"irregular", interval, samples};
}

// Integrals of a_g minus the line through its values at both ends, by the midpoint rule.
GroundDeviation by_small_steps(const GroundMotion& motion, double start, double end, double until) {
  constexpr int count = 200'000;
  const double h = (until - start) / count, first = motion.acceleration_at(start),
               slope = (motion.acceleration_at(end) - first) / (end - start);
  GroundDeviation sum;
  for (int i = 0; i < count; ++i) {
    const double t = h * (i + 0.5), d = motion.acceleration_at(start + t) - (first + slope * t);
    const double velocity = sum.velocity + 0.5 * h * d;
    const double displacement = sum.displacement + 0.5 * h * sum.velocity;
    sum.velocity += h * d;
    sum.displacement += h * velocity;
    sum.displacement_integral += h * displacement;
  }
  return sum;
}

void expect_near(const GroundDeviation& found, const GroundDeviation& expected, double length) {
  constexpr double close = 1e-7;  // of an acceleration of 1 m/s^2; the midpoint rule has an error of about 1e-9
  EXPECT_NEAR(found.velocity, expected.velocity, close * length);
  EXPECT_NEAR(found.displacement, expected.displacement, close * length * length);
  EXPECT_NEAR(found.displacement_integral, expected.displacement_integral, close * length * length * length);
}

TEST(GroundSpan, IntegratesTheDeviationFromTheLineThroughItsEnds) {
  const GroundMotion motion = irregular_motion();
  for (const auto& [start, end] : {std::pair{0.04, 0.2}, std::pair{0.05, 0.13}, std::pair{0.0, 0.06},
                                   std::pair{1.237, 1.2411}, std::pair{1.23, 1.25}, std::pair{3.9, 3.98}}) {
    SCOPED_TRACE(start);
    const GroundSpan span{motion, start, end};
    EXPECT_FALSE(span.is_straight());
    expect_near(span.deviation(), by_small_steps(motion, start, end, end), end - start);
    for (const double fraction : {0.1, 0.5, 0.77}) {
      const double until = start + fraction * (end - start);
      expect_near(span.deviation_at(until), by_small_steps(motion, start, end, until), end - start);
    }
  }
}

TEST(GroundSpan, IsStraightWithinOneInterval) {
  // Multiples of 0.01 are not exact in binary.
  const GroundMotion motion = irregular_motion(0.01);
  for (int i = 0; i + 1 < 200; ++i)
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{0.25, 0.75}, std::pair{0.5, 1.0}}) {
      const GroundSpan span{motion, (i + from) * 0.01, (i + to) * 0.01};
      ASSERT_TRUE(span.is_straight()) << i;
      EXPECT_EQ(span.deviation().velocity, 0.0);
      EXPECT_EQ(span.deviation().displacement, 0.0);
      EXPECT_EQ(span.deviation().displacement_integral, 0.0);
    }
  EXPECT_FALSE((GroundSpan{motion, 0.5, 0.52}.is_straight()));
}

// The velocity and the displacement of the ground itself are exact integrals too.
TEST(GroundSpan, AgreesWithTheVelocityAndDisplacementOfTheMotion) {
  const GroundMotion motion = irregular_motion();
  const std::vector<double> velocity = motion.velocity(), displacement = motion.displacement();
  const std::span<const double> a = motion.samples();
  const double interval = motion.time_step();
  for (const std::size_t first : {0, 3, 117})
    for (const std::size_t count : {2, 4, 8}) {
      const std::size_t last = first + count;
      const double h = static_cast<double>(count) * interval;
      const GroundDeviation d =
          GroundSpan{motion, static_cast<double>(first) * interval, static_cast<double>(last) * interval}.deviation();
      EXPECT_NEAR(velocity[first] + 0.5 * h * (a[first] + a[last]) + d.velocity, velocity[last], 1e-13);
      EXPECT_NEAR(displacement[first] + h * (velocity[first] + h * (a[first] / 3.0 + a[last] / 6.0)) + d.displacement,
                  displacement[last], 1e-13);
    }
}

TEST(GroundSpan, NoBumpIsLargerThanItsBounds) {
  const GroundMotion motion = irregular_motion();
  double closest = 0.0;
  for (int i = 0; i < 180; ++i) {
    for (const int intervals : {2, 3, 4, 8, 16}) {
      const double start = 0.02 * i + (i % 3 == 0 ? 0.007 : 0.0), end = 0.02 * (i + intervals);
      const GroundSpan span{motion, start, end};
      const GroundSpan::BumpBounds bounds = span.bump_bounds();
      for (int k = 1; k < 50; ++k) {
        const GroundBump bump = span.bump_at(start + (end - start) * k / 50.0);
        ASSERT_LE(std::abs(bump.displacement), bounds.displacement);
        ASSERT_LE(std::abs(bump.velocity), bounds.velocity);
        closest = std::max(closest, std::abs(bump.displacement) / bounds.displacement);
      }
    }
  }
  EXPECT_GT(closest, 0.4);
}

// The deviation with the largest bumps changes its sign where their kernels do.
TEST(GroundSpan, TheBoundsOfBumpsAreSharp) {
  constexpr double interval = 1e-3, d = 3.0;
  constexpr int count = 4000;
  std::vector<double> of_displacement(count + 1), of_velocity(count + 1);
  for (int i = 1; i < count; ++i) {
    const double x = static_cast<double>(i) / count;
    of_displacement[static_cast<std::size_t>(i)] = x < 0.25 || x > 0.75 ? d : -d;
    of_velocity[static_cast<std::size_t>(i)] = x < 0.5 ? d : -d;
  }
  const GroundMotion first{"first", interval, of_displacement}, second{"second", interval, of_velocity};
  const double end = interval * count;
  const GroundSpan one{first, 0.0, end}, other{second, 0.0, end};
  EXPECT_NEAR(std::abs(one.bump_at(0.5 * end).displacement), one.bump_bounds().displacement,
              0.01 * one.bump_bounds().displacement);
  EXPECT_NEAR(std::abs(other.bump_at(0.5 * end).velocity), other.bump_bounds().velocity,
              0.01 * other.bump_bounds().velocity);
}

}  // namespace
}  // namespace moat
