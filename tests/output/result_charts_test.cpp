#include "output/result_charts.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace moat {
namespace {

CaseResult result_with(std::vector<Column> columns) {
  CaseResult result;
  result.histories.columns = std::move(columns);
  return result;
}

CaseResult isolated_result() {
  return result_with({{"time", "", "s", {0.0, 1.0, 2.0}},
                      {"displacement", "base", "m", {0.0, 0.1, -0.05}},
                      {"displacement", "floor 1", "m", {0.0, 0.15, -0.1}},
                      {"displacement", "floor 2", "m", {0.0, 0.2, -0.1}},
                      {"absolute_acceleration", "base", "m/s^2", {0.0, 1.0, 2.0}},
                      {"absolute_acceleration", "floor 2", "m/s^2", {0.0, 3.0, 4.0}},
                      {"isolator_force", "bearings", "N", {0.0, 2e6, -1e6}},
                      {"impact_force", "moat left", "N", {0.0, 0.0, 5e6}},
                      {"impact_force", "moat right", "N", {0.0, 7e6, 0.0}}});
}

TEST(ResultCharts, ShowBaseAndTopAndAllImpacts) {
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

TEST(ResultCharts, LeaveOutWhatThereIsNot) {
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

TEST(ResultCharts, ABodyOfItsOwnIsDrawnOnce) {
  const std::vector<Chart> charts =
      history_charts(result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "base", "m", {0.0, 0.1}}}));
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].series.size(), 1u);
}

TEST(ResultCharts, FindABaseThatHasAPrefix) {
  const std::vector<Chart> charts = history_charts(result_with({{"time", "", "s", {0.0, 1.0}},
                                                                {"displacement", "database", "m", {0.0, 0.3}},
                                                                {"displacement", "north base", "m", {0.0, 0.1}},
                                                                {"displacement", "north floor 1", "m", {0.0, 0.2}}}));
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].series.size(), 2u);
  EXPECT_EQ(charts[0].series[0].name, "north base");
  EXPECT_EQ(charts[0].series[1].name, "north floor 1");
}

std::vector<std::string> names_in(const Chart& chart) {
  std::vector<std::string> names;
  for (const Series& series : chart.series) names.push_back(series.name);
  return names;
}

// Displacements at these nodes, the first of 1 m, the second of 2 m ...
CaseResult displacements_at(const std::vector<std::string>& nodes) {
  std::vector<Column> columns{{"time", "", "s", {0.0, 1.0}}};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    columns.push_back({"displacement", nodes[i], "m", {0.0, static_cast<double>(i + 1)}});
  return result_with(std::move(columns));
}

std::vector<std::string> drawn_of(const std::vector<std::string>& nodes) {
  return names_in(history_charts(displacements_at(nodes)).at(0));
}

using Names = std::vector<std::string>;

TEST(ResultCharts, ShowBaseAndTopOfEachBuilding) {
  EXPECT_EQ(
      drawn_of({"low base", "low floor 1", "low floor 2", "tall base", "tall floor 1", "tall floor 2", "tall floor 3"}),
      (Names{"low base", "low floor 2", "tall base", "tall floor 3"}));
  EXPECT_EQ(history_charts(displacements_at({"low base", "low floor 1", "tall base", "tall floor 1"}))[0].series[1].y,
            (std::vector<double>{0.0, 200.0}));
  // One of them without a name, one fixed to the ground.
  EXPECT_EQ(drawn_of({"base", "floor 1", "floor 2", "old floor 1", "old floor 2"}),
            (Names{"base", "floor 2", "old floor 2"}));
}

TEST(ResultCharts, ShowThreeBuildingsAtMost) {
  EXPECT_EQ(drawn_of({"a base", "a floor 1", "b base", "b floor 1", "c base", "c floor 1", "d base", "d floor 1"}),
            (Names{"a base", "a floor 1", "b base", "b floor 1", "c base", "c floor 1"}));
}

TEST(ResultCharts, AMoatWallIsNotTheTop) {
  EXPECT_EQ(drawn_of({"base", "floor 1", "moat left wall", "moat right wall"}), (Names{"base", "floor 1"}));
  EXPECT_EQ(drawn_of({"base", "roof", "moat left wall"}), (Names{"base", "roof"}));
  EXPECT_EQ(drawn_of({"base", "moat left wall"}), (Names{"base"}));
}

TEST(ResultCharts, OtherNamesBelongToTheBaseBeforeThem) {
  EXPECT_EQ(drawn_of({"base", "deck", "roof"}), (Names{"base", "roof"}));
  EXPECT_EQ(drawn_of({"north base", "north roof", "south base", "south deck", "south roof"}),
            (Names{"north base", "north roof", "south base", "south roof"}));
  EXPECT_EQ(drawn_of({"base", "floor 1", "tank"}), (Names{"base", "floor 1"})) << "floors go before other names";
  EXPECT_EQ(drawn_of({"left", "right"}), (Names{"right"})) << "no name is known";
  EXPECT_EQ(drawn_of({"first floor", "dance floor 2b"}), (Names{"dance floor 2b"})) << "not the name of a floor";
}

TEST(ResultCharts, HysteresisIsThatOfTheFirstIsolatedBuilding) {
  CaseResult result = displacements_at({"old floor 1", "tall base", "tall floor 1"});
  result.histories.columns.push_back({"isolator_force", "low bearings", "N", {0.0, 1e3}});
  result.histories.columns.push_back({"isolator_force", "tall bearings", "N", {0.0, 5e3}});
  const std::optional<Chart> loop = hysteresis_chart(result);
  ASSERT_TRUE(loop.has_value());
  EXPECT_EQ(loop->x_label, "tall base displacement [cm]");
  ASSERT_EQ(loop->series.size(), 1u);
  EXPECT_EQ(loop->series[0].name, "tall bearings");
  EXPECT_EQ(loop->series[0].x, (std::vector<double>{0.0, 200.0}));
  EXPECT_EQ(loop->series[0].y, (std::vector<double>{0.0, 5.0}));
}

TEST(ResultCharts, HysteresisIsForceOverDisplacementOfTheBase) {
  const std::optional<Chart> loop = hysteresis_chart(isolated_result());
  ASSERT_TRUE(loop.has_value());
  EXPECT_EQ(loop->x_label, "base displacement [cm]");
  EXPECT_EQ(loop->y_label, "isolator force [kN]");
  ASSERT_EQ(loop->series.size(), 1u);
  EXPECT_EQ(loop->series[0].x, (std::vector<double>{0.0, 10.0, -5.0}));
  EXPECT_EQ(loop->series[0].y, (std::vector<double>{0.0, 2000.0, -1000.0}));
}

TEST(ResultCharts, HysteresisNeedsIsolatorAndBase) {
  EXPECT_FALSE(hysteresis_chart(result_with({})).has_value());
  EXPECT_FALSE(hysteresis_chart(result_with({{"isolator_force", "bearings", "N", {0.0}}})).has_value());
  EXPECT_FALSE(hysteresis_chart(result_with({{"displacement", "base", "m", {0.0}}})).has_value());
  EXPECT_FALSE(hysteresis_chart(
                   result_with({{"displacement", "floor 1", "m", {0.0}}, {"isolator_force", "bearings", "N", {0.0}}}))
                   .has_value());
}

TEST(ResultCharts, RefuseColumnsOfDifferentLength) {
  EXPECT_THROW(history_charts(result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "base", "m", {0.0}}})),
               InputError);
  EXPECT_THROW(hysteresis_chart(result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "base", "m", {0.0}}})),
               InputError);
}

}  // namespace
}  // namespace moat
