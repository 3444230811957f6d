// Title and legend of a chart, in the strip above its plot area.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/charts/svg_writer.hpp"

namespace moat {

/// How a series is drawn: its colour, and the names that style sheets know.
struct SeriesColour {
  const char* colour;
  const char* line_class;
  const char* mark_class;
};
SeriesColour colour_of(const Chart& chart, std::size_t series);

struct LegendEntry {
  std::string name;
  Series::Style style;
  SeriesColour colour;
  double left;  ///< of the sample line, from the left end of the plot area, pixels
  int row;      ///< 0: beside the title
};

struct ChartHeading {
  std::string title;
  std::vector<LegendEntry> entries;
  double height;  ///< pixels
};

/// Height of a heading without rows of its own for the legend, pixels.
inline constexpr int title_strip = 40;

/// Title at the left, legend at the right where both fit into the width of the plot area, else below in rows of its
/// own. A text longer than the plot area is shortened.
ChartHeading lay_out_heading(const Chart& chart, double plot_width);

/// Draws it; `corner` is the upper left corner of the strip.
void draw_heading(SvgWriter& svg, const ChartHeading& heading, Pixel corner);

}  // namespace moat
