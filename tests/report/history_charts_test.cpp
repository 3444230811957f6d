#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::result_with;

CaseResult isolated_result() {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0, 2.0}},
                                   {"displacement", "base", "m", {0.0, 0.1, -0.05}},
                                   {"displacement", "floor 1", "m", {0.0, 0.15, -0.1}},
                                   {"displacement", "floor 2", "m", {0.0, 0.2, -0.1}},
                                   {"absolute_acceleration", "base", "m/s^2", {0.0, 1.0, 2.0}},
                                   {"absolute_acceleration", "floor 2", "m/s^2", {0.0, 3.0, 4.0}},
                                   {"isolator_force", "bearings", "N", {0.0, 2e6, -1e6}},
                                   {"impact_force", "moat left", "N", {0.0, 0.0, 5e6}},
                                   {"impact_force", "moat right", "N", {0.0, 7e6, 0.0}}});
  result.buildings = {{.base = "base", .floors = {"floor 1", "floor 2"}, .isolators = {"bearings"}}};
  return result;
}

TEST(HistoryCharts, ShowBaseAndTopAndAllImpacts) {
  const std::vector<Chart> charts = history_charts(isolated_result());
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[0].title, "Displacement");
  EXPECT_EQ(charts[0].x_label, "time [s]");
  EXPECT_EQ(charts[0].y_label, "displacement [cm]");
  ASSERT_EQ(charts[0].series.size(), 2u);
  EXPECT_EQ(charts[0].series[0].name, "base");
  EXPECT_EQ(charts[0].series[1].name, "floor 2");
  EXPECT_EQ(charts[0].series[1].y, (std::vector<double>{0.0, 20.0, -10.0}));
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(charts[0].x_range, (std::optional{std::pair{0.0, 2.0}}));
  EXPECT_EQ(charts[1].title, "Absolute acceleration");
  EXPECT_EQ(charts[1].series.size(), 2u);
  EXPECT_EQ(charts[2].title, "Impact force");
  ASSERT_EQ(charts[2].series.size(), 2u);
  EXPECT_EQ(charts[2].series[0].name, "moat left");
  EXPECT_EQ(charts[2].series[1].y, (std::vector<double>{0.0, 7000.0, 0.0}));
}

TEST(HistoryCharts, OfLongHistoriesKeepEveryPeakAndFewRows) {
  constexpr std::size_t rows = 300'000;
  Column time{"time", "", "s", {}}, motion{"displacement", "body", "m", {}},
      energy{"strain_energy", "structure", "J", {}}, input{"input_energy", "structure", "J", {}};
  for (std::size_t i = 0; i < rows; ++i) {
    time.values.push_back(0.005 * static_cast<double>(i));
    motion.values.push_back(std::sin(0.01 * static_cast<double>(i)));
    energy.values.push_back(motion.values.back() * motion.values.back());
    input.values.push_back(energy.values.back());
  }
  motion.values[123'456] = 5.0;
  motion.values[123'457] = -7.0;
  const CaseResult result = result_with({time, motion, energy, input});
  const Series curve = history_charts(result).at(0).series.at(0);
  EXPECT_LT(curve.x.size(), most_rows_of_charts);
  EXPECT_TRUE(std::ranges::is_sorted(curve.x));
  EXPECT_EQ(curve.x.front(), 0.0);
  EXPECT_EQ(curve.x.back(), time.values.back());
  EXPECT_EQ(std::ranges::max(curve.y), 500.0) << "cm";
  EXPECT_EQ(std::ranges::min(curve.y), -700.0);
  EXPECT_EQ(curve.x[static_cast<std::size_t>(std::ranges::max_element(curve.y) - curve.y.begin())],
            time.values[123'456]);
  EXPECT_EQ(history_charts(result, 3).at(0).series.at(0).x.size(), rows / 3);
  const Chart energies = energy_chart(result).value();
  EXPECT_LT(energies.series.back().x.size(), most_rows_of_charts);
  EXPECT_EQ(energies.series.front().name, "strain");
  EXPECT_EQ(energies.series.front().x.size(), 2 * energies.series.back().x.size()) << "forth and back";
}

TEST(HistoryCharts, LeaveOutGapsThatStayedOpen) {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}},
                                   {"impact_force", "left", "N", {0.0, 0.0}},
                                   {"impact_force", "right", "N", {0.0, 1e3}}});
  ASSERT_EQ(history_charts(result).size(), 1u);
  EXPECT_EQ(history_charts(result)[0].series.size(), 1u);
  result.histories.columns[2].values[1] = 0.0;
  EXPECT_TRUE(history_charts(result).empty()) << "nothing touched";
}

TEST(HistoryCharts, OfManyGapsShowTheLargestForces) {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}}});
  for (int i = 1; i <= 10; ++i)
    result.histories.columns.push_back({"impact_force", std::to_string(i), "N", {0.0, 1e3 * i}});
  const Chart chart = history_charts(result).at(0);
  ASSERT_EQ(chart.series.size(), 7u) << "as many as there are colours";
  EXPECT_EQ(chart.series.front().name, "10");
  EXPECT_EQ(chart.series.back().name, "4");
}

TEST(HistoryCharts, ShowAccelerationsInGToo) {
  const std::vector<Chart> charts = history_charts(isolated_result());
  EXPECT_FALSE(charts[0].second_unit.has_value());
  ASSERT_TRUE(charts[1].second_unit.has_value());
  EXPECT_EQ(charts[1].second_unit->symbol, "g");
}

TEST(HistoryCharts, LeaveOutWhatThereIsNot) {
  // A fixed-base building: no base, no gap.
  const std::vector<Chart> charts = history_charts(result_with({{"time", "", "s", {0.0, 1.0}},
                                                                {"displacement", "floor 1", "m", {0.0, 0.1}},
                                                                {"displacement", "floor 2", "m", {0.0, 0.2}}}));
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].series.size(), 1u);
  EXPECT_EQ(charts[0].series[0].name, "floor 2");
  EXPECT_TRUE(history_charts(result_with({})).empty());
  EXPECT_TRUE(history_charts(result_with({{"time", "", "s", {}}})).empty());
  // One row: the analysis failed in its first step, there is nothing to draw over time.
  EXPECT_TRUE(history_charts(result_with({{"time", "", "s", {0.0}}, {"displacement", "base", "m", {0.1}}})).empty());
  EXPECT_TRUE(history_charts(result_with({{"displacement", "base", "m", {0.0, 0.1}}})).empty());
}

TEST(HistoryCharts, ABodyOfItsOwnIsDrawnOnce) {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "tank", "m", {0.0, 0.1}}});
  result.buildings = {{.name = "tank", .floors = {"tank"}}};
  const std::vector<Chart> charts = history_charts(result);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].series.size(), 1u);
}

using Names = std::vector<std::string>;

Names names_in(const Chart& chart) {
  Names names;
  for (const Series& series : chart.series) names.push_back(series.name);
  return names;
}

// Displacements of the nodes of some buildings, the first of 1 m, the second of 2 m ...
CaseResult displacements_of(std::vector<BuildingParts> buildings) {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}}});
  double value = 0.0;
  const auto column = [&](const std::string& node) {
    result.histories.columns.push_back({"displacement", node, "m", {0.0, ++value}});
  };
  for (const BuildingParts& building : buildings) {
    if (!building.base.empty()) column(building.base);
    for (const std::string& floor : building.floors) column(floor);
  }
  result.buildings = std::move(buildings);
  return result;
}

TEST(HistoryCharts, ShowBaseAndTopOfEachBuilding) {
  const CaseResult result = displacements_of(
      {{.name = "low", .base = "cellar", .floors = {"deck", "roof"}}, {.name = "old", .floors = {"old 1", "old 2"}}});
  EXPECT_EQ(names_in(history_charts(result).at(0)), (Names{"cellar", "roof", "old 2"}));
  EXPECT_EQ(history_charts(result)[0].series[1].y, (std::vector<double>{0.0, 300.0}));
}

TEST(HistoryCharts, ShowThreeBuildingsAtMost) {
  const CaseResult result = displacements_of({{.base = "a", .floors = {"a1"}},
                                              {.base = "b", .floors = {"b1"}},
                                              {.base = "c", .floors = {"c1"}},
                                              {.base = "d", .floors = {"d1"}}});
  EXPECT_EQ(names_in(history_charts(result).at(0)), (Names{"a", "a1", "b", "b1", "c", "c1"}));
}

TEST(HistoryCharts, RefuseColumnsOfDifferentLength) {
  EXPECT_THROW(history_charts(result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "base", "m", {0.0}}})),
               InputError);
}

}  // namespace
}  // namespace moat
