#include "report/charts/orbit.hpp"

#include <gtest/gtest.h>

#include "report/charts/orbit_charts.hpp"
#include "report/charts/plan_view.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

// A base that moves along x and turns.
CaseResult turning_base() {
  CaseResult result = testing_report::result_with({{"time", "", "s", {0.0, 1.0, 2.0}},
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

TEST(Orbit, IsThatOfAPointOfARigidFloor) {
  const CaseResult result = turning_base();
  const std::optional<Orbit> orbit = orbit_of(result.model.diaphragms[0], result.histories);
  ASSERT_TRUE(orbit.has_value());
  const PlanVector at_row = orbit->displacement(1, {9.0, 10.0});
  EXPECT_DOUBLE_EQ(at_row.x, 0.1 - 0.01 * 10.0);
  EXPECT_DOUBLE_EQ(at_row.y, 0.01 * 9.0);
  const PlanVector between = orbit->displacement_at(1.5, {0.0, 0.0});
  EXPECT_DOUBLE_EQ(between.x, 0.15);
  EXPECT_DOUBLE_EQ(between.y, -0.05);
  EXPECT_EQ(orbit->displacement_at(9.0, {}), (PlanVector{0.2, -0.1})) << "the last row";
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

TEST(PlanView, ShowsOutlineWallsOrbitsAndImpacts) {
  const CaseResult result = testing_report::plan_result();
  const std::vector<std::string> views = plan_views(result);
  ASSERT_EQ(views.size(), 1u);
  EXPECT_EQ(testing_report::count(views[0], "<polyline"), 5u) << "corners and centre of mass";
  EXPECT_EQ(testing_report::count(views[0], "<circle"), result.impacts.size());
  for (int wall = 1; wall <= 4; ++wall)
    EXPECT_NE(views[0].find("moat wall " + std::to_string(wall)), std::string::npos) << wall;
  EXPECT_TRUE(plan_views(testing_report::line_result()).empty());
}

}  // namespace
}  // namespace moat
