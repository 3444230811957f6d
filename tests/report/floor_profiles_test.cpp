#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

CaseResult two_storeys() {
  CaseResult result;
  result.model.nodes = {{"base", 1.0, 0.0, 0.0}, {"floor 1", 1.0, 0.0, 4.0}, {"floor 2", 1.0, 0.0, 7.0}};
  result.model.elements = {{"storey 1", "storey", "", "base", "floor 1", {}},
                           {"storey 2", "storey", "", "floor 1", "floor 2", {}}};
  result.buildings = {{.name = "tower", .base = "base", .floors = {"floor 1", "floor 2"}}};
  result.peaks = {{"displacement", "floor 2", -0.3, "m"}, {"displacement", "base", 0.1, "m"},
                  {"displacement", "floor 1", 0.2, "m"},  {"drift", "storey 1", -0.01, "m"},
                  {"drift", "storey 2", 0.02, "m"},       {"impact_force", "moat", 1.0, "N"}};
  return result;
}

TEST(FloorProfiles, StandAtTheHeightsOfFloorsAndMiddlesOfStoreys) {
  const std::vector<Chart> charts = floor_profiles(two_storeys());
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].title, "Displacement over height");
  EXPECT_EQ(charts[0].x_label, "largest displacement [cm]");
  ASSERT_EQ(charts[0].series.size(), 1u);
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{10.0, 20.0, 30.0}));
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{0.0, 4.0, 7.0}));
  EXPECT_EQ(charts[1].title, "Drift over height");
  EXPECT_EQ(charts[1].series[0].x, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(charts[1].series[0].y, (std::vector<double>{2.0, 5.5}));
}

TEST(FloorProfiles, CountLevelsWhereNodesHaveNoHeights) {
  CaseResult result = two_storeys();
  for (NodeFacts& node : result.model.nodes) node.height = 0.0;
  EXPECT_EQ(floor_profiles(result).at(0).series[0].y, (std::vector<double>{0.0, 1.0, 2.0}));
}

TEST(FloorProfiles, NeedTwoLevels) {
  CaseResult result = two_storeys();
  result.buildings[0].floors.clear();
  EXPECT_TRUE(floor_profiles(result).empty());
}

TEST(FloorProfiles, ShowResultantsInPlan) {
  const CaseResult result = testing_report::plan_result();
  std::vector<std::string> titles;
  for (const Chart& chart : floor_profiles(result)) titles.push_back(chart.title);
  EXPECT_EQ(titles, (std::vector<std::string>{"Displacement over height", "Absolute acceleration over height"}))
      << "one storey has one drift";
}

}  // namespace
}  // namespace moat
