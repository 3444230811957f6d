// One chart of a drawing: plot area, axes and curves.
#pragma once

#include <utility>

#include "output/charts/chart.hpp"
#include "output/charts/chart_axis.hpp"
#include "output/charts/svg_writer.hpp"

namespace moat {

/// The rectangle of a plot area, pixels.
struct PlotArea {
  double left, top, width, height;
};

/// A chart ready to be drawn.
struct ChartPanel {
  Chart chart;  ///< with the points inside its x range alone
  ChartAxis y_axis;
  double left_margin;  ///< pixels that label and numbers of the y axis need
};

// Pixels beside and below a plot area.
inline constexpr int right_margin = 24;
inline constexpr int bottom_margin = 58;

/// The colour of a series.
chart_style::Paint paint_of(const Chart& chart, std::size_t series);

/// The panel of a chart whose plot area is `height` pixels high. Throws as svg_text does.
ChartPanel panel_of(const Chart& chart, int height);

/// Draws everything but title and legend.
void draw_panel(SvgWriter& svg, const ChartPanel& panel, const PlotArea& area);

}  // namespace moat
