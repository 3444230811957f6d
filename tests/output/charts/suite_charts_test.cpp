// Pictures and tables of a scaled suite.
#include "output/charts/suite_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/spectra/code_spectra.hpp"

namespace moat {
namespace {

using namespace units;

ScaledSuite suite() {
  const auto pulse = [](double period) {
    return near_fault_pulse({.pulse_period = period * s, .time_step = 0.02 * s, .quiet_after = 1 * s});
  };
  return scale_suite({{"one", {pulse(1.2), pulse(2.0)}}, {"two", {pulse(1.7), pulse(0.9)}}},
                     En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'},
                     SuiteScaling::asce_7_22(1.6 * s, 2 * s));
}

TEST(SpectraTable, HoldsTargetMeanAndRecords) {
  const ScaledSuite scaled = suite();
  const Table table = spectra_table(scaled);
  ASSERT_EQ(table.columns.size(), 5u);
  const auto& periods = table.values("period");
  EXPECT_EQ(periods.front(), 0.02);
  EXPECT_EQ(periods.back(), 4.0);  // as far as the target
  for (const double corner : {0.2, 0.6, 2.0}) EXPECT_TRUE(std::ranges::binary_search(periods, corner)) << corner;
  const auto &target = table.values("spectral_acceleration", "target"),
             &mean = table.values("spectral_acceleration", "mean"), &one = table.values("spectral_acceleration", "one"),
             &two = table.values("spectral_acceleration", "two");
  for (std::size_t k = 0; k < periods.size(); k += 20) {
    const std::vector period{periods[k] * s};
    EXPECT_EQ(target[k], scaled.target.acceleration(period[0]).si());
    EXPECT_EQ(one[k], pair_spectra(scaled.pairs[0].motion, period).rotd100[0]);
    EXPECT_NEAR(mean[k], 0.5 * (one[k] + two[k]), 1e-14);
  }
}

TEST(SpectraTable, HoldsBothComponentsWhereEachIsScaled) {
  ScaledSuite scaled = suite();
  scaled.scaling.spectrum = PairSpectrum::each_component;
  const Table table = spectra_table(scaled);
  ASSERT_EQ(table.columns.size(), 7u);
  const auto column = [&](const char* where) { return table.values("spectral_acceleration", where); };
  const auto &periods = table.values("period"), &mean = table.values("spectral_acceleration", "mean");
  for (std::size_t k = 0; k < periods.size(); k += 20) {
    const PairSpectra two = pair_spectra(scaled.pairs[1].motion, std::vector{periods[k] * s});
    EXPECT_EQ(column("two, first")[k], two.first[0]);
    EXPECT_EQ(column("two, second")[k], two.second[0]);
    EXPECT_NEAR(mean[k],
                0.5 * std::min(column("one, first")[k] + column("two, first")[k],
                               column("one, second")[k] + column("two, second")[k]),
                1e-14);
  }
  EXPECT_EQ(suite_charts(scaled)[0].series[5].name, "smaller mean");
}

TEST(SuiteCharts, ShowRecordsMeanTargetAndRange) {
  const ScaledSuite scaled = suite();
  const std::vector<Chart> charts = suite_charts(scaled);
  ASSERT_EQ(charts.size(), 2u);
  std::vector<std::string> names;
  for (const Series& series : charts[0].series) names.push_back(series.name);
  EXPECT_EQ(names, (std::vector<std::string>{"range of scaling", "records", "", "mean", "EN 1998-1 type 1, ground C",
                                             "0.9 target"}));
  EXPECT_EQ(charts[0].series[0].style, Series::Style::band);
  EXPECT_EQ(charts[0].series[0].x[0], scaled.scaling.shortest.si());
  EXPECT_EQ(charts[0].series[0].x[1], scaled.scaling.longest.si());
  EXPECT_TRUE(charts[0].logarithmic_x && charts[0].logarithmic_y);
  const Series &target = charts[0].series[4], &share = charts[0].series[5], &moved = charts[1].series[4];
  for (std::size_t k = 0; k < target.x.size(); ++k) {
    const double acceleration = scaled.target.acceleration(target.x[k] * s).si();
    EXPECT_NEAR(target.y[k], acceleration / 9.80665, 1e-12);
    EXPECT_NEAR(share.y[k], 0.9 * target.y[k], 1e-12);
    EXPECT_NEAR(moved.y[k], 100.0 * acceleration * std::pow(target.x[k] / (2.0 * pi), 2), 1e-9);
  }
  for (const Chart& chart : charts) EXPECT_NE(svg_text({chart}).find("<polyline"), std::string::npos);
}

TEST(ScalingTable, HasARowPerRecord) {
  const ScaledSuite scaled = suite();
  const Table table = scaling_table(scaled);
  EXPECT_EQ(table.columns[0].labels, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(table.values("own_factor"), scaled.own_factors);
  EXPECT_EQ(table.values("factor"), scaled.factors());
  EXPECT_EQ(table.values("pga", "second")[1], scaled.pairs[1].motion.second.peak_acceleration().si());
  EXPECT_NO_THROW(require_equal_lengths(table));
}

}  // namespace
}  // namespace moat
