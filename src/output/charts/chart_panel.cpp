#include "output/charts/chart_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "output/charts/thinned_line.hpp"

namespace moat {
namespace {

using namespace chart_style;
using Range = std::pair<double, double>;

// Pixels.
constexpr double tick_length = 5.0, number_gap = 4.0, y_label_middle = 18.0, y_label_room = 32.0;

void check_x_range(const Chart& chart) {
  if (!chart.x_range) return;
  const Check check{"Chart", chart.title};
  check.finite("start of x range", chart.x_range->first, "1");
  check.finite("end of x range", chart.x_range->second, "1");
  check.that(chart.x_range->first < chart.x_range->second, "the x range ends before it starts.",
             "Give its lower end first.");
  if (chart.logarithmic_x) check.positive("start of logarithmic x range", chart.x_range->first, "1");
}

/// Throws for the first value that cannot be drawn.
void check_points(const Chart& chart, const Series& series) {
  const Check check{"Series", series.name};
  const std::string x = "x of chart \"" + chart.title + "\"", y = "y of chart \"" + chart.title + "\"";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    check.finite(x, series.x[i], "1");
    check.finite(y, series.y[i], "1");
    if (chart.logarithmic_x) check.positive(x, series.x[i], "1", "The x axis is logarithmic.");
    if (chart.logarithmic_y) check.positive(y, series.y[i], "1", "The y axis is logarithmic.");
    if (chart.y_from_zero) check.not_negative(y, series.y[i], "1", "The y axis starts from zero.");
  }
}

/// The points inside the x range.
Series visible_part(const Chart& chart, Series series) {
  Check{"Series", series.name}.that(series.x.size() == series.y.size(), "x and y have different lengths.",
                                    "Give one y for every x.");
  std::size_t count = 0;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = series.x[i];
    if (chart.x_range && (x < chart.x_range->first || x > chart.x_range->second)) continue;
    series.x[count] = x;
    series.y[count++] = series.y[i];
  }
  series.x.resize(count);
  series.y.resize(count);
  check_points(chart, series);
  return series;
}

Range range_of(const Chart& chart, std::vector<double> Series::*values) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Series& series : chart.series)
    for (const double value : series.*values) range = {std::min(range.first, value), std::max(range.second, value)};
  const Check check{"Chart", chart.title};
  check.that(range.first <= range.second, "there is no point to draw.",
             "Give at least one series with a point inside the x range.");
  check.finite("range of an axis", range.second - range.first, "1");
  return range;
}

ChartAxis y_axis_of(const Chart& chart, double height) {
  const Range range = range_of(chart, &Series::y);
  if (!chart.y_from_zero || chart.logarithmic_y) return axis_around(range, chart.logarithmic_y, AxisSide::left, height);
  constexpr double room_above = 1.05;
  return axis_over({0.0, range.second > 0.0 ? room_above * range.second : 1.0}, false, AxisSide::left, height);
}

ChartAxis x_axis_of(const Chart& chart, double width) {
  return chart.x_range ? axis_over(*chart.x_range, chart.logarithmic_x, AxisSide::bottom, width)
                       : axis_around(range_of(chart, &Series::x), chart.logarithmic_x, AxisSide::bottom, width);
}

/// From values to pixels.
struct Scale {
  const PlotArea& area;
  const ChartAxis &x_axis, &y_axis;

  [[nodiscard]] double x(double value) const { return area.left + area.width * x_axis.share(value); }
  [[nodiscard]] double y(double value) const { return area.top + area.height * (1.0 - y_axis.share(value)); }
};

void draw_axes(SvgWriter& svg, const ChartPanel& panel, const Scale& scale) {
  const PlotArea& area = scale.area;
  const double right = area.left + area.width, bottom = area.top + area.height;
  for (const AxisTick& tick : scale.x_axis.ticks) {
    const double x = scale.x(tick.value);
    svg.line({{x, area.top}, {x, bottom}}, grid_line);
    svg.line({{x, bottom}, {x, bottom + tick_length}}, axis_line);
    svg.text({x, bottom + tick_length + number_gap + 0.5 * tick_size}, tick.label,
             {.size = tick_size, .anchor = "middle"});
  }
  for (const AxisTick& tick : scale.y_axis.ticks) {
    const double y = scale.y(tick.value);
    svg.line({{area.left, y}, {right, y}}, grid_line);
    svg.line({{area.left - tick_length, y}, {area.left, y}}, axis_line);
    svg.text({area.left - tick_length - number_gap, y}, tick.label, {.size = tick_size, .anchor = "end"});
  }
  if (!scale.y_axis.logarithmic && scale.y_axis.low < 0.0 && scale.y_axis.high > 0.0)
    svg.line({{area.left, scale.y(0.0)}, {right, scale.y(0.0)}}, axis_line, 0.5);
  svg.line({{area.left, area.top}, {area.left, bottom}, {right, bottom}}, axis_line);
  svg.text({area.left + 0.5 * area.width, bottom + tick_length + number_gap + tick_size + 9.0},
           shortened(panel.chart.x_label, label_size, area.width), {.anchor = "middle"});
  // The label may reach into the margin below, where nothing else is.
  svg.text({area.left - panel.left_margin + y_label_middle, area.top + 0.5 * area.height},
           shortened(panel.chart.y_label, label_size, area.height + 0.5 * bottom_margin),
           {.anchor = "middle", .upwards = true});
}

// Ticks and numbers of the second unit, above the plot area or to its right.
void draw_second_scale(SvgWriter& svg, const SecondUnit& unit, const Scale& scale) {
  const PlotArea& area = scale.area;
  const ChartAxis& first = unit.of_x ? scale.x_axis : scale.y_axis;
  const Range range{unit.per_first * first.low, unit.per_first * first.high};
  const ChartAxis axis = axis_over(range, first.logarithmic, unit.of_x ? AxisSide::bottom : AxisSide::left,
                                   unit.of_x ? area.width : area.height);
  const double right = area.left + area.width, beyond = tick_length + number_gap;
  for (const AxisTick& tick : axis.ticks) {
    const double value = tick.value / unit.per_first;
    const std::string label = tick.label + " " + unit.symbol;
    if (unit.of_x) {
      svg.line({{scale.x(value), area.top - tick_length}, {scale.x(value), area.top}}, axis_line);
      svg.text({scale.x(value), area.top - beyond - 0.5 * tick_size}, label, {.size = tick_size, .anchor = "middle"});
    } else {
      svg.line({{right, scale.y(value)}, {right + tick_length, scale.y(value)}}, axis_line);
      svg.text({right + beyond, scale.y(value)}, label, {.size = tick_size});
    }
  }
}

void draw_curve(SvgWriter& svg, const Series& series, Paint paint, const Scale& scale) {
  std::vector<Pixel> pixels;
  pixels.reserve(series.x.size());
  for (std::size_t i = 0; i < series.x.size(); ++i) pixels.push_back({scale.x(series.x[i]), scale.y(series.y[i])});
  pixels = thinned_line(pixels, 2 * static_cast<std::size_t>(scale.area.width));
  if (series.style == Series::Style::band)
    svg.area(pixels, paint, band_opacity);
  else if (series.style == Series::Style::markers || pixels.size() == 1)
    for (const Pixel& pixel : pixels) svg.disc(pixel, marker_radius, paint);
  else if (!pixels.empty())
    svg.line(pixels, paint, line_width, series.style == Series::Style::dashed);
}

}  // namespace

Paint paint_of(const Chart& chart, std::size_t series) {
  return palette[chart.series[series].colour.value_or(series) % palette.size()];
}

ChartPanel panel_of(const Chart& chart, int height) {
  check_x_range(chart);
  if (chart.second_unit)
    Check{"SecondUnit", chart.second_unit->symbol}.positive("per_first", chart.second_unit->per_first, "1");
  ChartPanel panel{.chart = chart, .y_axis = {}, .left_margin = 0.0};
  for (Series& series : panel.chart.series) series = visible_part(chart, std::move(series));
  panel.y_axis = y_axis_of(panel.chart, height);
  double widest = 0.0;
  for (const AxisTick& tick : panel.y_axis.ticks) widest = std::max(widest, text_width(tick.label, tick_size));
  panel.left_margin = std::ceil(y_label_room + widest + number_gap + tick_length);
  return panel;
}

void draw_panel(SvgWriter& svg, const ChartPanel& panel, const PlotArea& area) {
  const ChartAxis x_axis = x_axis_of(panel.chart, area.width);
  const Scale scale{area, x_axis, panel.y_axis};
  draw_axes(svg, panel, scale);
  if (panel.chart.second_unit) draw_second_scale(svg, *panel.chart.second_unit, scale);
  for (std::size_t i = 0; i < panel.chart.series.size(); ++i)
    draw_curve(svg, panel.chart.series[i], paint_of(panel.chart, i), scale);
}

}  // namespace moat
