#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::result_with;

// A floor that shakes with one period for a long time.
CaseResult shaken(double period, double interval, int rows) {
  std::vector<double> time, acceleration;
  for (int i = 0; i < rows; ++i) {
    time.push_back(interval * i);
    acceleration.push_back(std::sin(2.0 * std::numbers::pi * interval * i / period));
  }
  CaseResult result = result_with({{"time", "", "s", time}, {"absolute_acceleration", "roof", "m/s^2", acceleration}});
  result.buildings = {{.name = "tower", .floors = {"roof"}}};
  return result;
}

TEST(FloorSpectra, AreThoseOfOscillatorsOnTheFloor) {
  const std::vector<Chart> charts = floor_spectra(shaken(0.5, 0.005, 8000));
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].series.size(), 1u);
  const Series& spectrum = charts[0].series[0];
  EXPECT_DOUBLE_EQ(spectrum.x.front(), 0.05);
  EXPECT_DOUBLE_EQ(spectrum.x.back(), 5.0);
  // Of the steady vibration with r = period of the oscillator / period of the floor, and for a stiff oscillator at most
  // r times as much more of the free vibration at the start.
  const auto amplification = [](double r) { return 1.0 / std::hypot(1.0 - r * r, 2.0 * 0.05 * r); };
  const double stiff = spectrum.x.front() / 0.5;
  EXPECT_GE(spectrum.y.front(), amplification(stiff) * 0.999);
  EXPECT_LE(spectrum.y.front(), amplification(stiff) * (1.0 + stiff));
  const auto largest = std::ranges::max_element(spectrum.y);
  const double resonant = spectrum.x[static_cast<std::size_t>(largest - spectrum.y.begin())] / 0.5;
  EXPECT_NEAR(resonant, 1.0, 0.05);
  EXPECT_NEAR(*largest, amplification(resonant), 0.01 * *largest);
}

TEST(FloorSpectra, NeedALongHistory) { EXPECT_TRUE(floor_spectra(shaken(0.5, 0.005, 99)).empty()); }

TEST(FloorSpectra, HaveOneChartForEachComponentInPlan) {
  const std::vector<Chart> charts = floor_spectra(testing_report::plan_result());
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].title, "Floor response spectra along x");
  EXPECT_EQ(charts[0].x_label, "period of an oscillator with 5 % damping [s]");
  EXPECT_EQ(charts[1].series.size(), 2u) << "base and top";
}

}  // namespace
}  // namespace moat
