#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

// The upper edge of a band: its way back.
std::vector<double> upper_edge(const Series& band) {
  const auto half = static_cast<std::ptrdiff_t>(band.y.size() / 2);
  return {band.y.rbegin(), band.y.rbegin() + half};
}

TEST(EnergyChart, StacksUpToTheInput) {
  for (const CaseResult& result : {testing_report::line_result(), testing_report::plan_result()}) {
    const std::optional<Chart> chart = energy_chart(result);
    ASSERT_TRUE(chart.has_value());
    const Series& input = chart->series.back();
    EXPECT_EQ(input.name, "input");
    EXPECT_EQ(chart->series.size(), result.energy.in_plan ? 7u : 6u);
    const std::vector<double> top = upper_edge(chart->series[chart->series.size() - 2]);
    ASSERT_EQ(top.size(), input.y.size());
    for (std::size_t i = 0; i < top.size(); ++i)
      EXPECT_NEAR(top[i], input.y[i], 1e-3 * 1e-3 * result.energy.largest_input) << i;
    // Each band begins where the one below ends.
    for (std::size_t i = 1; i + 1 < chart->series.size(); ++i) {
      const std::vector<double> edge = upper_edge(chart->series[i - 1]);
      EXPECT_EQ(std::vector<double>(chart->series[i].y.begin(),
                                    chart->series[i].y.begin() + static_cast<std::ptrdiff_t>(edge.size())),
                edge);
    }
  }
}

TEST(EnergyChart, IsNoneWithoutEnergies) {
  EXPECT_FALSE(energy_chart(testing_report::result_with({{"time", "", "s", {0.0, 1.0}}})).has_value());
}

}  // namespace
}  // namespace moat
