#include "report/charts/result_charts.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::result_with;

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

TEST(IsolatorLoops, AreNoneWithoutColumns) { EXPECT_TRUE(isolator_loops(result_with({})).empty()); }

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

}  // namespace
}  // namespace moat
