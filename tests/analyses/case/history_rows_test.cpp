// Histories have their rows at the multiples of the interval for any steps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/line/shear_spring.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double frequency = 2.0 * std::numbers::pi / 0.5, amplitude = 0.01;  // 1/s, m

// A free vibration u = amplitude cos wt for a second.
Table rows(Time interval_of_motion, Time interval_of_rows, const TransientOptions& options) {
  Model model = oscillator({.frequency = frequency, .displacement = amplitude});
  return run_case(model, still_ground(1 * s, interval_of_motion),
                  {.transient = options, .history_interval = interval_of_rows, .error_bars = ErrorBarMode::never})
      .histories;
}

void expect_rows_at_multiples(const Table& table, double interval) {
  const std::vector<double>& times = table.values("time");
  ASSERT_EQ(times.size(), static_cast<std::size_t>(1.0 / interval * (1.0 + 1e-12)) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) ASSERT_DOUBLE_EQ(times[i], interval * static_cast<double>(i));
}

// Of displacement, relative to the amplitude.
double error(const Table& table) {
  const std::vector<double>&times = table.values("time"), &u = table.values("displacement", "body");
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i)
    largest = std::max(largest, std::abs(u[i] / amplitude - std::cos(frequency * times[i])));
  return largest;
}

TEST(HistoryRows, FinerThanAdaptiveStepsAreAtTheMultiples) {
  const Table table = rows(5 * ms, 1 * ms, {.largest_step = 5 * ms});
  expect_rows_at_multiples(table, 1e-3);
  // A cubic through values and rates misses the middle of a step by (w h)^4/384; the steps' own error of period,
  // (w h)^4/480 of it, adds up over two cycles.
  const double fourth = std::pow(frequency * 5e-3, 4);
  EXPECT_LT(error(table), fourth * (1.0 / 384.0 + frequency * 1.0 / 480.0));
}

TEST(HistoryRows, BetweenFixedStepsAreAtTheMultiples) {
  const Table table = rows(10 * ms, 3 * ms, {.step = 10 * ms});
  expect_rows_at_multiples(table, 3e-3);
  // The same with the period of average acceleration, long by (w h)^2/12 of itself.
  const double phase = frequency * 10e-3;
  EXPECT_LT(error(table), frequency * 1.0 * phase * phase / 12.0 + std::pow(phase, 4) / 384.0);
}

TEST(HistoryRows, BetweenExactAndFourthOrderStepsAreAtTheMultiplesAndOfFourthOrder) {
  for (const bool exact : {true, false}) {
    double before = 0.0;
    for (const double interval : {40e-3, 20e-3, 10e-3, 5e-3}) {
      if (interval == (exact ? 40e-3 : 5e-3)) continue;
      SCOPED_TRACE(interval);
      const Table table = rows(interval * s, 1 * ms,
                               exact ? TransientOptions{.integrator = ExactBetweenEvents{}}
                                     : TransientOptions{.integrator = Newmark::fourth_order(), .step = interval * s});
      expect_rows_at_multiples(table, 1e-3);
      const double now = error(table);
      if (exact) {
        EXPECT_LT(now, std::pow(frequency * interval, 4) / 384.0);
      }
      if (before > 0.0) {
        EXPECT_NEAR(order(before, now), 4.0, 0.2);
      }
      before = now;
    }
  }
}

TEST(HistoryRows, ExactStepsThatEndAtRowsKeepTheExactValues) {
  EXPECT_LT(error(rows(10 * ms, 20 * ms, {.integrator = ExactBetweenEvents{}})), 1e-12);
}

}  // namespace
}  // namespace moat
