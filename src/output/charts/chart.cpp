#include "output/charts/chart.hpp"

#include <algorithm>
#include <string_view>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "output/charts/chart_panel.hpp"
#include "output/files/file_io.hpp"

namespace moat {
namespace {

using namespace chart_style;

// Pixels.
constexpr double second_scale_above = 18.0, second_scale_beside = 44.0;
constexpr double title_strip = 40.0, legend_row = 22.0, sample_width = 26.0, sample_gap = 6.0, between_entries = 18.0;

struct LegendEntry {
  std::size_t series;
  std::string name;
  double left;  // of the sample line, from the left end of the plot area, pixels
  int row;      // 0: beside the title
};

/// The strip above a plot area. A text longer than the plot area is shortened.
struct Heading {
  std::string title;
  std::vector<LegendEntry> legend;
  double height;  // pixels
};

/// Title at the left, legend at the right where both fit into the width of the plot area, else below in rows of its
/// own.
Heading heading_of(const Chart& chart, double plot_width) {
  constexpr double bold = 1.08;  // over plain letters
  Heading heading{shortened(chart.title, bold * title_size, plot_width), {}, title_strip};
  if (chart.second_unit && chart.second_unit->of_x) heading.height += second_scale_above;
  const auto width_of = [](const LegendEntry& entry) {
    return sample_width + sample_gap + text_width(entry.name, label_size) + between_entries;
  };
  double total = -between_entries;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::string& name = chart.series[i].name;
    if (name.empty()) continue;
    heading.legend.push_back({i, shortened(name, label_size, plot_width - sample_width - sample_gap), 0.0, 0});
    total += width_of(heading.legend.back());
  }
  if (heading.legend.empty()) return heading;
  const bool beside_title = text_width(heading.title, bold * title_size) + between_entries + total <= plot_width;
  double left = beside_title ? plot_width - total : 0.0;
  int row = beside_title ? 0 : 1;
  for (LegendEntry& entry : heading.legend) {
    if (!beside_title && left > 0.0 && left + width_of(entry) - between_entries > plot_width) {
      left = 0.0;
      ++row;
    }
    entry.left = left;
    entry.row = row;
    left += width_of(entry);
  }
  heading.height += row * legend_row;
  return heading;
}

/// Draws a heading whose upper left corner is `corner`.
void draw_heading(SvgWriter& svg, const Heading& heading, const Chart& chart, Pixel corner) {
  const double first_row = corner.y + 0.5 * title_strip + 2.0;
  svg.text({corner.x, first_row}, heading.title, {.size = title_size, .bold = true});
  for (const LegendEntry& entry : heading.legend) {
    const Pixel start{corner.x + entry.left, first_row + entry.row * legend_row};
    const double end = start.x + sample_width;
    constexpr double half_height = 5.0;
    const Series::Style style = chart.series[entry.series].style;
    const Paint paint = paint_of(chart, entry.series);
    if (style == Series::Style::band)
      svg.area({{start.x, start.y - half_height},
                {end, start.y - half_height},
                {end, start.y + half_height},
                {start.x, start.y + half_height}},
               paint, band_opacity);
    else if (style == Series::Style::markers)
      svg.disc({start.x + 0.5 * sample_width, start.y}, marker_radius, paint);
    else
      svg.line({start, {end, start.y}}, paint, 2.0, style == Series::Style::dashed);
    svg.text({end + sample_gap, start.y}, entry.name, {});
  }
}

/// "Displacement: displacement [cm] over time [s]; base from -13.5 to 14.2, ...".
std::string description_of(const Chart& chart) {
  constexpr int digits = 5;
  std::string text = (chart.title.empty() ? "" : chart.title + ": ") + chart.y_label + " over " + chart.x_label;
  const char* separator = "; ";
  for (const Series& series : chart.series) {
    if (series.y.empty()) continue;
    const auto [low, high] = std::ranges::minmax(series.y);
    text += separator + (series.name.empty() ? "" : series.name + " ") + "from " + to_significant(low, digits) +
            " to " + to_significant(high, digits);
    separator = ", ";
  }
  return text + ".";
}

/// Places panels row by row. Those of a row have one height, and all have one width, so that plot areas are aligned.
std::string draw(const std::vector<Chart>& charts, int width, int height, int columns) {
  const int panel_width = width / columns, plot_height = height - static_cast<int>(title_strip) - bottom_margin;
  std::vector<ChartPanel> panels;
  double left_margin = 0.0, beside = right_margin;
  std::string titles, descriptions;
  for (const Chart& chart : charts) {
    panels.push_back(panel_of(chart, plot_height));
    left_margin = std::max(left_margin, panels.back().left_margin);
    if (chart.second_unit && !chart.second_unit->of_x) beside = right_margin + second_scale_beside;
    if (!chart.title.empty()) titles += (titles.empty() ? "" : "; ") + chart.title;
    descriptions += (descriptions.empty() ? "" : " ") + description_of(panels.back().chart);
  }
  const double plot_width = panel_width - left_margin - beside;
  const auto per_row = static_cast<std::size_t>(columns);
  std::vector<Heading> headings;
  std::vector<double> tops{0.0};  // of every row, and the end of the last
  for (std::size_t i = 0; i < charts.size(); ++i) {
    headings.push_back(heading_of(charts[i], plot_width));
    if (i % per_row == 0) tops.push_back(tops.back());
    tops.back() = std::max(tops.back(), tops[i / per_row] + headings[i].height + plot_height + bottom_margin);
  }
  SvgWriter svg{width, static_cast<int>(tops.back()), titles, descriptions};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = static_cast<double>(i % per_row) * panel_width + left_margin, top = tops[i / per_row];
    panels[i].left_margin = left_margin;
    draw_panel(
        svg, panels[i],
        {left, tops[i / per_row + 1] - bottom_margin - plot_height, plot_width, static_cast<double>(plot_height)});
    draw_heading(svg, headings[i], charts[i], {left, top});
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
