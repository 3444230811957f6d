#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace moat
