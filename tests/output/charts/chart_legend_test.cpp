#include "output/charts/chart_legend.hpp"

#include <gtest/gtest.h>

#include <string>

#include "output/charts/chart.hpp"

namespace moat {
namespace {

// Sums of widths are rounded: the last entry must not go to a row below the title for that.
TEST(ChartLegend, IsBesideTheTitleOrInRowsOfItsOwn) {
  Chart chart{.title = "Incremental dynamic analysis", .x_label = "x", .y_label = "y", .series = {}};
  for (const char* name : {"16 %", "median of 12 records", "84 %"})
    chart.series.push_back({.name = name, .x = {0, 1}, .y = {0, 1}});
  int beside = 0, below = 0;
  for (double plot_width = 300.0; plot_width < 1200.0; plot_width += 0.7) {
    const ChartHeading heading = lay_out_heading(chart, plot_width);
    const bool in_title_row = heading.entries.front().row == 0;
    (in_title_row ? beside : below) += 1;
    EXPECT_EQ(heading.height > title_strip, !in_title_row) << plot_width;
    for (const LegendEntry& entry : heading.entries)
      EXPECT_EQ(entry.row == 0, in_title_row) << plot_width << " " << entry.name;
  }
  EXPECT_GT(beside, 0);
  EXPECT_GT(below, 0);
}

}  // namespace
}  // namespace moat
