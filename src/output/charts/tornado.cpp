#include "output/charts/tornado.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "output/charts/chart_axis.hpp"
#include "output/charts/svg_writer.hpp"

namespace moat {
namespace {

using namespace chart_style;

// Pixels.
constexpr double heading_height = 44.0, row_height = 34.0, axis_height = 58.0, side_margin = 16.0, end_radius = 5.0;

struct TornadoEnd {
  std::string label;
  double value;
  bool filled;
};

// The known ends of a bar, the lower value first.
std::vector<TornadoEnd> ends_of(const TornadoBar& bar) {
  std::vector<TornadoEnd> ends;
  if (std::isfinite(bar.decreased)) ends.push_back({bar.decrease, bar.decreased, false});
  if (std::isfinite(bar.increased)) ends.push_back({bar.increase, bar.increased, true});
  std::ranges::stable_sort(ends, {}, &TornadoEnd::value);
  return ends;
}

std::pair<double, double> extent_of(const Tornado& tornado) {
  double low = tornado.nominal, high = tornado.nominal;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const TornadoBar& bar : tornado.bars)
    for (const double value : {bar.decreased, bar.increased}) include(value);
  for (const double side : {-1.0, 1.0}) include(tornado.nominal + side * tornado.error);
  return {low, high};
}

double longest_label(const Tornado& tornado) {
  double width = 0.0;
  for (const TornadoBar& bar : tornado.bars)
    for (const std::string& label : {bar.decrease, bar.increase}) width = std::max(width, text_width(label, tick_size));
  return width + 2.0 * end_radius;
}

void draw_end(SvgWriter& svg, const TornadoEnd& end, Pixel place, bool label_on_left) {
  svg.disc(place, end_radius, palette[0]);
  if (!end.filled) svg.disc(place, end_radius - line_width, paper);
  const double away = 2.0 * end_radius;
  svg.text({place.x + (label_on_left ? -away : away), place.y}, end.label,
           {.size = tick_size, .anchor = label_on_left ? "end" : "start"});
}

std::string words_of(const Tornado& tornado) {
  constexpr int shown_digits = 4;
  std::string text = tornado.value_label + ", nominal " + to_significant(tornado.nominal, shown_digits);
  for (const TornadoBar& bar : tornado.bars)
    for (const TornadoEnd& end : ends_of(bar)) text += ", " + end.label + " " + to_significant(end.value, shown_digits);
  return text + ".";
}

}  // namespace

std::string svg_text(const Tornado& tornado, int width) {
  const Check check{"Tornado", tornado.title};
  check.that(width >= 300, "width", width, "pixels", ">= 300 pixels");
  check.that(!tornado.bars.empty(), "there are no bars.", "Give at least one.");
  check.finite("nominal", tornado.nominal, "1");
  const double margin = side_margin + longest_label(tornado), left = margin, plot_width = width - 2.0 * margin;
  const double floor = heading_height + row_height * static_cast<double>(tornado.bars.size());
  const ChartAxis axis = axis_around(extent_of(tornado), false, AxisSide::bottom, plot_width);
  const auto x_of = [&](double value) { return left + plot_width * axis.share(value); };

  SvgWriter svg{width, static_cast<int>(floor + axis_height), tornado.title, words_of(tornado)};
  svg.text({side_margin, 0.5 * heading_height}, shortened(tornado.title, title_size, width - 2.0 * side_margin),
           {.size = title_size, .bold = true});
  for (const AxisTick& tick : axis.ticks) {
    svg.line({{x_of(tick.value), heading_height}, {x_of(tick.value), floor}}, grid_line);
    svg.text({x_of(tick.value), floor + 5.0 + 0.5 * tick_size}, tick.label, {.size = tick_size, .anchor = "middle"});
  }
  svg.text({0.5 * width, floor + 5.0 + tick_size + 14.0}, shortened(tornado.value_label, label_size, width),
           {.anchor = "middle"});
  for (std::size_t i = 0; i < tornado.bars.size(); ++i) {
    const double y = heading_height + row_height * (static_cast<double>(i) + 0.5), half = 0.25 * row_height;
    const std::vector<TornadoEnd> ends = ends_of(tornado.bars[i]);
    if (ends.empty()) continue;
    // A bar with one end reaches to the nominal value.
    const double other = ends.size() == 1 ? tornado.nominal : ends.back().value;
    const double low = x_of(std::min(ends.front().value, other)), high = x_of(std::max(ends.front().value, other));
    svg.area({{low, y - half}, {high, y - half}, {high, y + half}, {low, y + half}}, palette[0], band_opacity);
    draw_end(svg, ends.front(), {x_of(ends.front().value), y},
             ends.size() == 2 || ends.front().value < tornado.nominal);
    if (ends.size() == 2) draw_end(svg, ends.back(), {x_of(ends.back().value), y}, false);
  }
  const double nominal = x_of(tornado.nominal), above = heading_height - 5.0;
  svg.line({{nominal, heading_height}, {nominal, floor}}, ink, line_width);
  if (std::isfinite(tornado.error)) {
    const double low = x_of(tornado.nominal - tornado.error), high = x_of(tornado.nominal + tornado.error);
    svg.line({{low, above}, {high, above}}, palette[1], 2.0 * line_width);
    for (const double end : {low, high}) svg.line({{end, above - 4.0}, {end, above + 4.0}}, palette[1], line_width);
  }
  return svg.finish();
}

Table table_of(const Tornado& tornado) {
  const std::size_t bracket = tornado.value_label.rfind('[');
  const std::string unit = bracket == std::string::npos
                               ? "1"
                               : tornado.value_label.substr(bracket + 1, tornado.value_label.size() - bracket - 2);
  Table table{{{"nominal", "", unit, {tornado.nominal}}, {"error", "", unit, {tornado.error}}}};
  for (const TornadoBar& bar : tornado.bars) {
    table.columns.push_back({bar.decrease, "", unit, {bar.decreased}});
    table.columns.push_back({bar.increase, "", unit, {bar.increased}});
  }
  return table;
}

}  // namespace moat
