#include "output/peak_trackers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "output/peak_tracker.hpp"

namespace moat {
namespace {

// Quantities of every kind at one instant: smooth ones, noise, steps that stand still for a while, and zero.
std::vector<double> values_at(double time, std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> noise;
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i + 1);
    switch (i % 4) {
      case 0:
        values.push_back(std::sin(x * time) * (1.0 + 0.1 * time));
        break;
      case 1:
        values.push_back(noise(random));
        break;
      case 2:
        values.push_back(std::round(3.0 * std::sin(0.7 * x * time)));
        break;
      default:
        values.push_back(0.0);
    }
  }
  return values;
}

class ManyPeakTrackers : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ManyPeakTrackers, FindWhatEachAloneFinds) {
  const std::size_t count = GetParam();
  PeakTrackers together{count};
  std::vector<PeakTracker> alone(count);
  std::mt19937 random{7};
  std::uniform_real_distribution<double> length{0.01, 0.4};
  double time = 0.0;
  for (int step = 0; step < 3000; ++step) {
    const std::vector<double> values = values_at(time, count, random), rates = values_at(time + 0.3, count, random);
    const bool event = step % 97 == 96;
    if (event)
      together.restart(time, values.data(), rates.data());
    else
      together.add(time, values.data(), rates.data());
    for (std::size_t i = 0; i < count; ++i)
      event ? alone[i].restart(time, values[i], rates[i]) : alone[i].add(time, values[i], rates[i]);
    // An event is a second sample at the instant of the first.
    if (step % 97 != 95) time += length(random);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(together.magnitude(i), alone[i].magnitude()) << "quantity " << i << ", step " << step;
      ASSERT_EQ(together.time(i), alone[i].time()) << "quantity " << i << ", step " << step;
    }
  }
  EXPECT_TRUE(count == 0 || together.magnitude(0) > 1.0);
}

INSTANTIATE_TEST_SUITE_P(Counts, ManyPeakTrackers, ::testing::Values(0, 1, 3, 4, 7, 40));

}  // namespace
}  // namespace moat
