#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "base/error.hpp"
#include "in_folder.hpp"
#include "report/html.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::result_with;

class ResultChartFiles : public testing::InFolder {};

TEST_F(ResultChartFiles, EveryChartIsAPictureWithItsNumbers) {
  const CaseResult result = testing_report::line_result();
  const ResultCharts charts = result_charts(result);
  write_charts(charts, folder);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{folder / "charts"})
    names.insert(entry.path().filename().string());
  EXPECT_EQ(names.size(), 2 * charts.all().size());
  for (const char* name : {"displacement", "absolute_acceleration", "impact_force", "drift_over_height",
                           "loops_of_the_isolators", "energy", "floor_response_spectra"})
    for (const char* extension : {".svg", ".csv"}) EXPECT_TRUE(names.contains(std::string{name} + extension)) << name;
  EXPECT_TRUE(std::filesystem::exists(folder / "charts.svg"));
  EXPECT_TRUE(testing::read_file(folder / "charts" / "displacement.csv")
                  .starts_with("time [s],displacement [cm] base,displacement [cm] floor 2\n0,0,0\n"));
}

TEST_F(ResultChartFiles, ChartsOfOneTitleHaveFilesOfTheirOwn) {
  const Chart chart{.title = "Same (title)", .x_label = "x", .y_label = "y", .series = {{"", {0.0, 1.0}, {0.0, 1.0}}}};
  ResultCharts charts;
  charts.histories = {chart, chart};
  write_charts(charts, folder);
  EXPECT_TRUE(std::filesystem::exists(folder / "charts" / "same_title.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "charts" / "same_title_2.csv"));
}

TEST_F(ResultChartFiles, NothingIsWrittenWithoutCharts) {
  write_charts(result_charts({}), folder);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

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
    EXPECT_EQ(chart->series.size(), 6u) << "bands of zeros are left out: friction on a line, viscous in plan";
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

// A base that moves along x and turns.
CaseResult turning_base() {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0, 2.0}},
                                   {"displacement_x", "base", "m", {0.0, 0.1, 0.2}},
                                   {"displacement_y", "base", "m", {0.0, 0.0, -0.1}},
                                   {"rotation", "base", "rad", {0.0, 0.01, 0.0}}});
  result.model.diaphragms = {{.name = "base",
                              .gyration = 5.0,
                              .centre_of_mass = {1.0, 0.0},
                              .outline = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}},
                              .is_base = true}};
  return result;
}

TEST(OrbitCharts, ShowCentreAndCornersOfEveryBase) {
  CaseResult result = turning_base();
  const std::vector<Chart> charts = orbit_charts(result);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].title, "Orbit of base");
  EXPECT_EQ(charts[0].x_label, "displacement along x [cm]");
  ASSERT_EQ(charts[0].series.size(), 4u);
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{0.0, 10.0, 20.0}));
  EXPECT_NEAR(charts[0].series[3].x[1], 0.0, 1e-12);
  EXPECT_NEAR(charts[0].series[3].y[1], 9.0, 1e-12);
  result.model.diaphragms[0].is_base = false;
  EXPECT_TRUE(orbit_charts(result).empty());
}

CaseResult two_buildings() {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}},
                                   {"isolator_deformation", "pendulums", "m", {0.0, 0.2}},
                                   {"isolator_force", "pendulums", "N", {0.0, 5e3}},
                                   {"isolator_deformation", "sliders", "m", {0.0, 0.1}},
                                   {"isolator_force", "sliders", "N", {0.0, -1e3}},
                                   {"isolator_force", "no deformation", "N", {0.0, 1.0}}});
  result.buildings = {{.name = "fixed", .floors = {"floor"}},
                      {.name = "new", .base = "cellar", .isolators = {"pendulums", "sliders", "no deformation"}}};
  return result;
}

TEST(IsolatorLoops, AreForceOverDeformationOfEveryIsolatedBuilding) {
  const std::vector<Chart> loops = isolator_loops(two_buildings());
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].title, "Isolators of new");
  EXPECT_EQ(loops[0].x_label, "deformation [cm]");
  EXPECT_EQ(loops[0].y_label, "force [kN]");
  ASSERT_EQ(loops[0].series.size(), 2u);
  EXPECT_EQ(loops[0].series[0].name, "pendulums");
  EXPECT_EQ(loops[0].series[0].x, (std::vector<double>{0.0, 20.0}));
  EXPECT_EQ(loops[0].series[0].y, (std::vector<double>{0.0, 5.0}));
  EXPECT_EQ(loops[0].series[1].y, (std::vector<double>{0.0, -1.0}));
}

TEST(IsolatorLoops, ShowBothComponentsOfTheWidestBearingInPlan) {
  CaseResult result = result_with({{"time", "", "s", {0.0, 1.0}},
                                   {"isolator_deformation_x", "bearing 1", "m", {0.0, 0.1}},
                                   {"isolator_deformation_y", "bearing 1", "m", {0.0, 0.1}},
                                   {"isolator_force_x", "bearing 1", "N", {0.0, 1e3}},
                                   {"isolator_force_y", "bearing 1", "N", {0.0, 2e3}},
                                   {"isolator_deformation_x", "bearing 2", "m", {0.0, 0.0}},
                                   {"isolator_deformation_y", "bearing 2", "m", {0.0, -0.3}},
                                   {"isolator_force_x", "bearing 2", "N", {0.0, 3e3}},
                                   {"isolator_force_y", "bearing 2", "N", {0.0, 4e3}}});
  result.model.diaphragms.push_back({.name = "base"});
  result.buildings = {{.name = "tower", .isolators = {"bearing 1", "bearing 2"}}};
  // The widest component is not the largest deformation.
  result.peaks = {{"isolator_deformation", "bearings", 0.31, "m"},
                  {"isolator_deformation", "bearing 1", 0.29, "m"},
                  {"isolator_deformation", "bearing 2", 0.31, "m"}};
  EXPECT_EQ(isolator_loops(result).at(0).title, "Loops of bearing 2");
  result.peaks[1].value = 0.32;
  EXPECT_EQ(isolator_loops(result).at(0).title, "Loops of bearing 1");
  result.peaks[1].value = 0.29;
  const std::vector<Chart> loops = isolator_loops(result);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].title, "Loops of bearing 2");
  ASSERT_EQ(loops[0].series.size(), 2u);
  EXPECT_EQ(loops[0].series[1].name, "along y");
  EXPECT_EQ(loops[0].series[1].x, (std::vector<double>{0.0, -30.0}));
  EXPECT_EQ(loops[0].series[1].y, (std::vector<double>{0.0, 4.0}));
}

TEST(IsolatorLoops, RefuseColumnsOfDifferentLength) {
  EXPECT_THROW(isolator_loops(result_with({{"time", "", "s", {0.0, 1.0}}, {"displacement", "base", "m", {0.0}}})),
               InputError);
}

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

// The ground stands still and has the acceleration of the motion; its storey is in the middle between ground and
// floor 1.
TEST(FloorProfiles, OfAFixedBuildingBeginAtTheGround) {
  CaseResult result = two_storeys();
  result.model.elements[0].first = "ground";
  result.buildings[0].base = "";
  result.motion.peak_acceleration = 4.0;
  result.peaks.erase(result.peaks.begin() + 1);
  result.peaks.push_back({"absolute_acceleration", "floor 1", 5.0, "m/s^2"});
  result.peaks.push_back({"absolute_acceleration", "floor 2", -9.0, "m/s^2"});
  const std::vector<Chart> charts = floor_profiles(result);
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[0].series[0].x, (std::vector<double>{0.0, 20.0, 30.0}));
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{0.0, 4.0, 7.0}));
  EXPECT_EQ(charts[1].series[0].y, (std::vector<double>{2.0, 5.5})) << "drifts";
  EXPECT_EQ(charts[2].series[0].x, (std::vector<double>{4.0, 5.0, 9.0}));
  ASSERT_TRUE(charts[2].second_unit.has_value());
  EXPECT_EQ(charts[2].second_unit->symbol, "g");
  EXPECT_NEAR(charts[2].second_unit->per_first, 1.0 / 9.80665, 1e-15);
}

TEST(FloorProfiles, ShowRatiosOfDrift) {
  CaseResult result = two_storeys();
  result.peaks.push_back({"drift_ratio", "storey 1", 0.25, "%"});
  result.peaks.push_back({"drift_ratio", "storey 2", -0.5, "%"});
  const Chart chart = floor_profiles(result).at(2);
  EXPECT_EQ(chart.title, "Drift ratio over height");
  EXPECT_EQ(chart.x_label, "largest drift ratio [%]");
  EXPECT_EQ(chart.series[0].x, (std::vector<double>{0.25, 0.5}));
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

TEST(ChartGrid, MakesAPictureOfEachChart) {
  const Chart chart{.title = "A", .x_label = "gap [cm]", .y_label = "1", .series = {{"", {0.0, 1.0}, {0.0, 1.0}}}};
  const std::string html = html::chart_grid({chart, chart}, 500, 300);
  EXPECT_EQ(html.find("<div class=\"charts\" style=\"--width: 500px\">"), 0u) << html;
  EXPECT_EQ(testing_report::count(html, "<svg "), 2u);
  EXPECT_EQ(testing_report::count(html, "width=\"500\" height=\"300\" viewBox"), 2u) << html;
}

}  // namespace
}  // namespace moat
