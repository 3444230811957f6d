#include "output/charts/chart.hpp"

#include <algorithm>
#include <string_view>

#include "base/check.hpp"
#include "output/charts/chart_description.hpp"
#include "output/charts/chart_legend.hpp"
#include "output/charts/chart_panel.hpp"
#include "output/files/file_io.hpp"

namespace moat {
namespace {

/// Places panels row by row. Those of a row have one height, and all have one width, so that plot areas are aligned.
std::string draw(const std::vector<Chart>& charts, int width, int height, int columns) {
  const int panel_width = width / columns;
  const int plot_height = height - title_strip - bottom_margin;
  std::vector<ChartPanel> panels;
  double left_margin = 0.0;
  for (const Chart& chart : charts) {
    panels.push_back(panel_of(chart, panel_width - right_margin, plot_height));
    left_margin = std::max(left_margin, panels.back().left_margin);
  }
  for (ChartPanel& panel : panels) panel.left_margin = left_margin;
  const double plot_width = panel_width - left_margin - right_margin;

  std::vector<ChartHeading> headings;
  for (const Chart& chart : charts) headings.push_back(lay_out_heading(chart, plot_width));
  const auto per_row = static_cast<std::size_t>(columns);
  std::vector<double> heading_heights;  // of every row
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (i % per_row == 0) heading_heights.push_back(0.0);
    heading_heights.back() = std::max(heading_heights.back(), headings[i].height);
  }
  double total_height = 0.0;
  for (const double heading : heading_heights) total_height += heading + plot_height + bottom_margin;

  SvgWriter svg{width, static_cast<int>(total_height), titles_of(panels), description_of(panels)};
  double top = 0.0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / per_row, column = i % per_row;
    const double left = static_cast<double>(column) * panel_width + left_margin;
    draw_heading(svg, headings[i], {left, top});
    draw_panel(svg, panels[i], {left, top + heading_heights[row], plot_width, static_cast<double>(plot_height)});
    if (column + 1 == per_row) top += heading_heights[row] + plot_height + bottom_margin;
  }
  return svg.finish();
}

}  // namespace

std::string svg_text(const std::vector<Chart>& charts, int width, int height, int columns) {
  const std::string_view title = charts.empty() ? std::string_view{} : charts.front().title;
  const Check check{"Chart", title};
  check.that(!charts.empty(), "there is no chart to draw.", "Give at least one.");
  check.that(columns >= 1, "columns", columns, "1", ">= 1");
  check.that(width / columns >= 200, "width", width, "pixels", ">= 200 pixels for every column");
  check.that(height >= 150, "height", height, "pixels", ">= 150 pixels");
  return draw(charts, width, height, columns);
}

void write_svg(const Chart& chart, const std::filesystem::path& path, int width, int height) {
  write_svg(std::vector{chart}, path, width, height);
}

void write_svg(const std::vector<Chart>& charts, const std::filesystem::path& path, int width, int panel_height,
               int columns) {
  write_file(path, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_text(charts, width, panel_height, columns));
}

}  // namespace moat
