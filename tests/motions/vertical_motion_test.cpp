// Vertical acceleration of a mass on the vertical component of a motion.
#include "motions/vertical_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/gauss.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

using namespace units;

GroundMotion upwards(double interval, const std::vector<double>& samples) {
  return GroundMotion{"up", interval, std::vector<double>(samples.size(), 0.0)}.with_component_z(samples);
}

TEST(VerticalMotion, NothingMovesWithoutAVerticalComponent) {
  const VerticalMotion none{GroundMotion{"along", 0.02, {1.0, 2.0}}, 0.1 * s, 0.05};
  EXPECT_EQ(none.acceleration(0.01), 0.0);
  EXPECT_EQ(none.rate(0.01), 0.0);
}

TEST(VerticalMotion, ModeHasTheComputedAccelerations) {
  const VerticalMotion mode{upwards(0.1, {0.0, 3.0, -2.0, 1.0, 0.0}), 0.12 * s, 0.05};
  struct {
    double time, acceleration;
  } const expected[] = {{0.05, 1.2469297662}, {0.1, 3.3838208052}, {0.15, 0.7875087554}, {0.2, -2.7314658369},
                        {0.3, 1.2395667091},  {0.4, 0.1038389197}, {0.5, 0.0650375239}};
  for (const auto& each : expected) EXPECT_NEAR(mode.acceleration(each.time), each.acceleration, 6e-11) << each.time;
  EXPECT_NEAR(mode.longest_step(), 0.006, 1e-15);
}

// Duhamel's integral of a_v and of its rate, by Gauss's rule in parts that are short against the period.
struct Duhamel {
  double acceleration = 0.0, rate = 0.0;
};
Duhamel duhamel(const std::vector<double>& samples, double interval, double period, double z, double time) {
  const double o = 2.0 * std::numbers::pi / period, damped = o * std::sqrt(1.0 - z * z);
  double value = 0.0, rate = 0.0, ground_now = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double from = static_cast<double>(i) * interval, to = std::min(from + interval, time);
    const auto sampled = [&](double at) { return samples[i] + (at - from) / interval * (samples[i + 1] - samples[i]); };
    if (to <= from) break;
    ground_now = time > static_cast<double>(samples.size() - 1) * interval ? 0.0 : sampled(to);
    const int parts = static_cast<int>(std::ceil((to - from) / (0.05 * period)));
    for (int k = 0; k < parts; ++k)
      Gauss::visit(from + k * (to - from) / parts, from + (k + 1) * (to - from) / parts, [&](double at, double weight) {
        const double since = time - at, fading = std::exp(-z * o * since), sine = std::sin(damped * since) / damped;
        value -= weight * sampled(at) * fading * sine;
        rate -= weight * sampled(at) * fading * (std::cos(damped * since) - z * o * sine);
      });
  }
  const double acceleration = -(2.0 * z * o * rate + o * o * value);
  return {acceleration, -(2.0 * z * o * (acceleration - ground_now) + o * o * rate)};
}

TEST(VerticalMotion, ModeIsTheDuhamelIntegral) {
  std::mt19937 random{3};
  std::normal_distribution<double> normal{0.0, 3.0};
  std::vector<double> samples(150);
  for (double& sample : samples) sample = normal(random);
  for (const double period : {0.01, 0.05, 0.12, 0.4, 1.0})
    for (const double z : {0.0, 0.02, 0.05, 0.3, 0.9}) {
      const double interval = 0.01;
      const VerticalMotion mode{upwards(interval, samples), period * s, z};
      // In the first interval, in the middle, at the last sample, long after it.
      for (const double time : {0.0037, 0.1, 0.7321, 1.49, 1.4937, 3.3}) {
        const Duhamel expected = duhamel(samples, interval, period, z, time);
        ASSERT_NEAR(mode.acceleration(time), expected.acceleration, 1e-9) << period << " " << z << " " << time;
        const double scale = 2.0 * std::numbers::pi / period;
        if (time != 1.49) {
          ASSERT_NEAR(mode.rate(time) / scale, expected.rate / scale, 1e-9) << period << " " << z;
        }
      }
    }
}

TEST(VerticalMotion, RateIsThatOfTheAcceleration) {
  const VerticalMotion mode{upwards(0.05, {2.0, 3.0, -2.0, 1.0}), 0.2 * s, 0.1};
  const double step = 1e-6;
  for (const double time : {0.0, 0.02, 0.05, 0.13, 0.15, 0.4}) {
    const auto at = [&](double steps) { return mode.acceleration(time + steps * step); };
    EXPECT_NEAR(mode.rate(time), (4.0 * at(1.0) - 3.0 * at(0.0) - at(2.0)) / (2.0 * step), 2e-5) << time;
  }
  // The ground's acceleration jumps at both ends, by 2 and by 1 m/s^2: the dashpot's force follows.
  const double damping = 2.0 * 0.1 * 2.0 * std::numbers::pi / 0.2;
  const double close = 1e-8;
  EXPECT_EQ(mode.rate(-close), 0.0);
  EXPECT_NEAR(mode.rate(0.0), damping * 2.0, 1e-12);
  EXPECT_NEAR(mode.rate(0.15) - mode.rate(0.15 - close), -damping * 1.0, 1e-4);
  EXPECT_NEAR(mode.rate(0.05), mode.rate(0.05 - close), 1e-4);
}

TEST(VerticalMotion, WithoutDampingItKeepsItsEnergy) {
  // After a ramp of one whole period the mode stands still; after half of it, it vibrates on forever.
  const double period = 0.2, top = 4.0;
  const VerticalMotion whole{upwards(0.2, {0.0, top, top, top}), period * s, 0.0};
  for (const double time : {0.2, 0.25, 0.3, 0.555}) EXPECT_NEAR(whole.acceleration(time), top, 1e-12);
  const VerticalMotion half{upwards(0.1, {0.0, top, top, top, top, top}), period * s, 0.0};
  // a_v = top (1 + (2/pi) sin(o (t - 0.1))) after the ramp of half a period.
  for (const double time : {0.1, 0.15, 0.2, 0.37, 0.5})
    EXPECT_NEAR(half.acceleration(time),
                top * (1.0 + 2.0 / std::numbers::pi * std::sin(2.0 * std::numbers::pi / period * (time - 0.1))), 1e-12);
  const double later = half.acceleration(0.63);
  EXPECT_NEAR(half.acceleration(0.63 + 1000.0 * period), later, 1e-8);
}

}  // namespace
}  // namespace moat
