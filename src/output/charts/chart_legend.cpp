#include "output/charts/chart_legend.hpp"

#include "output/charts/chart_style.hpp"
#include "output/charts/text_width.hpp"

namespace moat {
namespace {

using namespace chart_style;

// Pixels.
constexpr double row_height = 22.0;
constexpr double sample_width = 26.0;
constexpr double sample_gap = 6.0;
constexpr double between = 18.0;
// Bold letters are wider.
constexpr double bold_over_plain = 1.08;

}  // namespace

SeriesColour colour_of(const Chart& chart, std::size_t series) {
  const std::size_t place = chart.series[series].colour.value_or(series) % palette.size();
  if (place == black) return {palette[place], black_line_class, black_mark_class};
  return {palette[place], "", ""};
}

ChartHeading lay_out_heading(const Chart& chart, double plot_width) {
  ChartHeading heading{shortened(chart.title, bold_over_plain * title_size, plot_width), {}, title_strip};
  std::vector<double> widths;
  double total = -between;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.name.empty()) continue;
    const std::string name = shortened(series.name, label_size, plot_width - sample_width - sample_gap);
    widths.push_back(sample_width + sample_gap + text_width(name, label_size) + between);
    total += widths.back();
    heading.entries.push_back({name, series.style, colour_of(chart, i), 0.0, 0});
  }
  if (widths.empty()) return heading;

  const double title_width = text_width(heading.title, bold_over_plain * title_size);
  const bool beside_title = title_width + between + total <= plot_width;
  double left = beside_title ? plot_width - total : 0.0;
  int row = beside_title ? 0 : 1;
  for (std::size_t i = 0; i < heading.entries.size(); ++i) {
    if (!beside_title && left > 0.0 && left + widths[i] - between > plot_width) {
      left = 0.0;
      ++row;
    }
    heading.entries[i].left = left;
    heading.entries[i].row = row;
    left += widths[i];
  }
  heading.height += row * row_height;
  return heading;
}

void draw_heading(SvgWriter& svg, const ChartHeading& heading, Pixel corner) {
  const double first_row = corner.y + 0.5 * title_strip + 2.0;
  svg.text({corner.x, first_row}, heading.title, {.size = title_size, .bold = true});
  for (const LegendEntry& entry : heading.entries) {
    const Pixel start{corner.x + entry.left, first_row + entry.row * row_height};
    constexpr double half_height = 5.0;
    if (entry.style == Series::Style::band)
      svg.area({{start.x, start.y - half_height},
                {start.x + sample_width, start.y - half_height},
                {start.x + sample_width, start.y + half_height},
                {start.x, start.y + half_height}},
               entry.colour.colour, band_opacity, entry.colour.mark_class);
    else if (entry.style == Series::Style::markers)
      svg.disc({start.x + 0.5 * sample_width, start.y}, marker_radius, entry.colour.colour, entry.colour.mark_class);
    else
      svg.line(start, {start.x + sample_width, start.y},
               {.colour = entry.colour.colour,
                .width = 2.0,
                .dashed = entry.style == Series::Style::dashed,
                .kind = entry.colour.line_class});
    svg.text({start.x + sample_width + sample_gap, start.y}, entry.name, {.size = label_size});
  }
}

}  // namespace moat
