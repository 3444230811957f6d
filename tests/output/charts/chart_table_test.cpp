#include "output/charts/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

TEST(ChartTable, HasXOnceWhereAllCurvesShareIt) {
  const Table table = table_of({.title = "Displacement",
                                .x_label = "time [s]",
                                .y_label = "displacement [cm]",
                                .series = {{"base", {0.0, 1.0}, {2.0, 3.0}}, {"floor 1", {0.0, 1.0}, {4.0, 5.0}}}});
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.columns[0].quantity, "time");
  EXPECT_EQ(table.columns[0].unit, "s");
  EXPECT_EQ(table.columns[0].where, "");
  EXPECT_EQ(table.columns[2].quantity, "displacement");
  EXPECT_EQ(table.columns[2].unit, "cm");
  EXPECT_EQ(table.values("displacement", "floor 1"), (std::vector<double>{4.0, 5.0}));
}

TEST(ChartTable, FillsShorterCurves) {
  const Table table = table_of({.title = "",
                                .x_label = "a",
                                .y_label = "b [N]",
                                .series = {{"long", {0.0, 1.0}, {2.0, 3.0}}, {"short", {5.0}, {6.0}}}});
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(table.columns[2].where, "short");
  EXPECT_EQ(table.columns[2].unit, "1");
  EXPECT_EQ(table.columns[3].values[0], 6.0);
  EXPECT_TRUE(std::isnan(table.columns[3].values[1]));
}

TEST(ChartTable, GivesBothEdgesOfABand) {
  const Table table =
      table_of({.title = "",
                .x_label = "time [s]",
                .y_label = "energy [kJ]",
                .series = {{"kinetic", {0.0, 1.0, 1.0, 0.0}, {1.0, 2.0, 30.0, 10.0}, Series::Style::band},
                           {"input", {0.0, 1.0}, {7.0, 8.0}}}});
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(table.values("energy", "kinetic, first edge"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(table.values("energy", "kinetic, second edge"), (std::vector<double>{10.0, 30.0}));
  EXPECT_EQ(table.values("energy", "input"), (std::vector<double>{7.0, 8.0}));
}

}  // namespace
}  // namespace moat
