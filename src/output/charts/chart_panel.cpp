#include "output/charts/chart_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "output/charts/chart_curve.hpp"
#include "output/charts/chart_style.hpp"
#include "output/charts/text_width.hpp"

namespace moat {
namespace {

using namespace chart_style;
using Range = std::pair<double, double>;

// Pixels.
constexpr double tick_length = 5.0;
constexpr double number_gap = 4.0;
constexpr double y_label_middle = 18.0;
constexpr double y_label_room = 32.0;

void check_x_range(const Chart& chart) {
  if (!chart.x_range) return;
  const Check check{"Chart", chart.title};
  check.finite("start of x range", chart.x_range->first, "1");
  check.finite("end of x range", chart.x_range->second, "1");
  check.that(chart.x_range->first < chart.x_range->second, "the x range ends before it starts.",
             "Give its lower end first.");
  if (chart.logarithmic_x) check.positive("start of logarithmic x range", chart.x_range->first, "1");
}

Range range_of(const Chart& chart, const std::vector<Curve>& curves, std::vector<double> Curve::*values,
               std::string_view axis) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Curve& curve : curves)
    for (const double value : curve.*values) {
      range.first = std::min(range.first, value);
      range.second = std::max(range.second, value);
    }
  const Check check{"Chart", chart.title};
  check.that(range.first <= range.second, "there is no point to draw.",
             "Give at least one series with a point inside the x range.");
  check.finite("range of " + std::string{axis}, range.second - range.first, "1");
  return range;
}

ChartAxis y_axis_of(const Chart& chart, Range range, double height) {
  if (!chart.y_from_zero || chart.logarithmic_y) return axis_around(range, chart.logarithmic_y, AxisSide::left, height);
  constexpr double room_above = 1.05;
  return axis_over({0.0, range.second > 0.0 ? room_above * range.second : 1.0}, false, AxisSide::left, height);
}

double left_margin_of(const ChartAxis& y_axis) {
  double widest = 0.0;
  for (const AxisTick& tick : y_axis.ticks) widest = std::max(widest, text_width(tick.label, tick_size));
  return std::ceil(y_label_room + widest + number_gap + tick_length);
}

/// From values to pixels.
struct Scale {
  const PlotArea& area;
  const ChartAxis &x_axis, &y_axis;

  [[nodiscard]] double x(double value) const { return area.left + area.width * x_axis.share(value); }
  [[nodiscard]] double y(double value) const { return area.top + area.height * (1.0 - y_axis.share(value)); }
};

void draw_axes(SvgWriter& svg, const Chart& chart, const Scale& scale) {
  const PlotArea& area = scale.area;
  const double right = area.left + area.width, bottom = area.top + area.height;
  const Stroke grid{.colour = grid_line, .kind = grid_class}, axis{.colour = axis_line, .kind = axis_class};
  for (const AxisTick& tick : scale.x_axis.ticks)
    svg.line({scale.x(tick.value), area.top}, {scale.x(tick.value), bottom}, grid);
  for (const AxisTick& tick : scale.y_axis.ticks)
    svg.line({area.left, scale.y(tick.value)}, {right, scale.y(tick.value)}, grid);
  const bool zero_inside = !scale.y_axis.logarithmic && scale.y_axis.low < 0.0 && scale.y_axis.high > 0.0;
  if (zero_inside)
    svg.line({area.left, scale.y(0.0)}, {right, scale.y(0.0)}, {.colour = axis_line, .width = 0.5, .kind = axis_class});

  for (const AxisTick& tick : scale.x_axis.ticks) {
    const double x = scale.x(tick.value);
    svg.line({x, bottom}, {x, bottom + tick_length}, axis);
    svg.text({x, bottom + tick_length + number_gap + 0.5 * tick_size}, tick.label,
             {.size = tick_size, .anchor = Lettering::Anchor::middle});
  }
  for (const AxisTick& tick : scale.y_axis.ticks) {
    const double y = scale.y(tick.value);
    svg.line({area.left - tick_length, y}, {area.left, y}, axis);
    svg.text({area.left - tick_length - number_gap, y}, tick.label,
             {.size = tick_size, .anchor = Lettering::Anchor::end});
  }
  svg.line({area.left, bottom}, {right, bottom}, axis);
  svg.line({area.left, area.top}, {area.left, bottom}, axis);

  const Lettering label{.size = label_size, .anchor = Lettering::Anchor::middle};
  svg.text({area.left + 0.5 * area.width, bottom + tick_length + number_gap + tick_size + 9.0},
           shortened(chart.x_label, label_size, area.width), label);
}

void draw_y_label(SvgWriter& svg, const ChartPanel& panel, const PlotArea& area) {
  // It may reach into the margin below, where nothing else is.
  const double room = area.height + 0.5 * bottom_margin;
  svg.text({area.left - panel.left_margin + y_label_middle, area.top + 0.5 * area.height},
           shortened(panel.chart->y_label, label_size, room),
           {.size = label_size, .anchor = Lettering::Anchor::middle, .upwards = true});
}

void draw_curve(SvgWriter& svg, const Curve& curve, Series::Style style, const SeriesColour& colour,
                const Scale& scale) {
  std::vector<Pixel> pixels;
  pixels.reserve(curve.x.size());
  for (std::size_t i = 0; i < curve.x.size(); ++i) pixels.push_back({scale.x(curve.x[i]), scale.y(curve.y[i])});
  if (style == Series::Style::band) {
    svg.area(pixels, colour.colour, band_opacity, colour.mark_class);
    return;
  }
  if (style == Series::Style::markers || pixels.size() == 1) {
    for (const Pixel& pixel : pixels) svg.disc(pixel, marker_radius, colour.colour, colour.mark_class);
    return;
  }
  if (pixels.empty()) return;
  svg.polyline(pixels, {.colour = colour.colour,
                        .width = line_width,
                        .dashed = style == Series::Style::dashed,
                        .kind = colour.line_class});
}

}  // namespace

ChartPanel panel_of(const Chart& chart, int width, int height) {
  check_x_range(chart);
  ChartPanel panel{.chart = &chart, .curves = {}, .x_range = {}, .y_range = {}, .y_axis = {}, .left_margin = 0.0};
  for (const Series& series : chart.series) panel.curves.push_back(drawn_curve(chart, series, width, height));
  panel.x_range = range_of(chart, panel.curves, &Curve::x, "x");
  panel.y_range = range_of(chart, panel.curves, &Curve::y, "y");
  panel.y_axis = y_axis_of(chart, panel.y_range, height);
  panel.left_margin = left_margin_of(panel.y_axis);
  return panel;
}

void draw_panel(SvgWriter& svg, const ChartPanel& panel, const PlotArea& area) {
  const Chart& chart = *panel.chart;
  const ChartAxis x_axis = chart.x_range
                               ? axis_over(*chart.x_range, chart.logarithmic_x, AxisSide::bottom, area.width)
                               : axis_around(panel.x_range, chart.logarithmic_x, AxisSide::bottom, area.width);
  const Scale scale{area, x_axis, panel.y_axis};
  draw_axes(svg, chart, scale);
  draw_y_label(svg, panel, area);
  for (std::size_t i = 0; i < panel.curves.size(); ++i)
    draw_curve(svg, panel.curves[i], chart.series[i].style, colour_of(chart, i), scale);
}

}  // namespace moat
