#include "output/charts/heat_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "output/charts/chart_axis.hpp"
#include "output/charts/svg_writer.hpp"

namespace moat {
namespace {

using namespace chart_style;

// Pixels.
constexpr double top = 44.0, bottom = 58.0, right = 120.0, scale_width = 18.0, scale_gap = 24.0;
constexpr int digits = 3;
constexpr const char* no_value = "#c8c8c8";

// Without an exponent where the number is not very large.
std::string cell_number(double value) {
  constexpr double small = 1e3, very_large = 1e7;
  const double magnitude = std::abs(value);
  if (magnitude < small || magnitude >= very_large) return to_significant(value, digits);
  const double unit = std::pow(10.0, std::floor(std::log10(magnitude)) - (digits - 1));
  return to_fixed(std::round(value / unit) * unit, 0);
}

struct ColourRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  [[nodiscard]] double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

ColourRange checked_range(const HeatMap& map, int width, int height) {
  const Check check{"HeatMap", map.title};
  check.that(width >= 300, "width", width, "pixels", ">= 300 pixels");
  check.that(height >= 200, "height", height, "pixels", ">= 200 pixels");
  check.that(!map.x_values.empty() && !map.y_values.empty(), "there are no cells.", "Give x_values and y_values.");
  check.that(map.values.size() == map.y_values.size(), "the numbers of rows and of y_values differ.",
             "Give one name for every row.");
  ColourRange range;
  for (const std::vector<double>& row : map.values) {
    check.that(row.size() == map.x_values.size(), "the numbers of columns and of x_values differ.",
               "Give one name for every column.");
    for (const double value : row)
      if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
  }
  check.that(range.low <= range.high, "there is no value to draw.", "Give at least one that is finite.");
  return range;
}

double widest(const std::vector<std::string>& names) {
  double width = 0.0;
  for (const std::string& name : names) width = std::max(width, text_width(name, tick_size));
  return width;
}

/// Every how many of `count` names fit without overlapping.
std::size_t every(std::size_t count, double room_for_each, double most) {
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(most / std::max(room_for_each, 1.0))), 1, count);
}

void draw_cell(SvgWriter& svg, double value, const ColourRange& range, Pixel corner, double width, double height) {
  const bool known = std::isfinite(value);
  // Cells overlap by a little, so that no line shows between them.
  svg.rectangle(corner, width + 0.3, height + 0.3, known ? viridis(range.share(value)) : no_value);
  const std::string number = known ? cell_number(value) : "";
  constexpr double plate_margin = 3.0, plate_height = 16.0;
  const double room = text_width(number, tick_size) + 4.0 * plate_margin;
  if (!known || room > width || plate_height + plate_margin > height) return;
  const Pixel middle{corner.x + 0.5 * width, corner.y + 0.5 * height};
  svg.rectangle({middle.x - 0.5 * room + plate_margin, middle.y - 0.5 * plate_height}, room - 2.0 * plate_margin,
                plate_height, paper.colour);
  svg.text(middle, number, {.size = tick_size, .anchor = "middle", .on_paper = true});
}

void draw_scale(SvgWriter& svg, const HeatMap& map, const ColourRange& range, Pixel corner, double height) {
  constexpr int bands = 64;
  for (int i = 0; i < bands; ++i)
    svg.rectangle({corner.x, corner.y + height * (bands - 1 - i) / bands}, scale_width, height / bands + 0.5,
                  viridis((i + 0.5) / bands));
  const std::vector<AxisTick> ticks = range.high > range.low
                                          ? axis_over({range.low, range.high}, false, AxisSide::left, height).ticks
                                          : std::vector{AxisTick{range.low, to_significant(range.low, digits)}};
  for (const AxisTick& tick : ticks)
    svg.text({corner.x + scale_width + 5.0, corner.y + height * (1.0 - range.share(tick.value))}, tick.label,
             {.size = tick_size});
  svg.text({corner.x + right - scale_gap - 14.0, corner.y + 0.5 * height},
           shortened(map.value_label, label_size, height), {.anchor = "middle", .upwards = true});
}

}  // namespace

std::string viridis(double share) {
  constexpr std::array<std::array<double, 3>, 9> knots{{{68, 1, 84},
                                                        {71, 44, 122},
                                                        {59, 81, 139},
                                                        {44, 113, 142},
                                                        {33, 144, 141},
                                                        {39, 173, 129},
                                                        {92, 200, 99},
                                                        {170, 220, 50},
                                                        {253, 231, 37}}};
  const double place = std::clamp(share, 0.0, 1.0) * (knots.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), knots.size() - 2);
  std::array<unsigned, 3> colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = static_cast<unsigned>(
        std::lround(std::lerp(knots[below][i], knots[below + 1][i], place - static_cast<double>(below))));
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text.data();
}

std::string svg_text(const HeatMap& map, int width, int height) {
  const ColourRange range = checked_range(map, width, height);
  const std::size_t columns = map.x_values.size(), rows = map.y_values.size();
  const double left = 44.0 + std::min(widest(map.y_values), 0.3 * width), floor = height - bottom;
  const double cell_width = (width - left - right) / static_cast<double>(columns);
  const double cell_height = (floor - top) / static_cast<double>(rows);
  const auto x_of = [&](std::size_t column) { return left + cell_width * static_cast<double>(column); };
  const auto y_of = [&](std::size_t row) { return floor - cell_height * static_cast<double>(row + 1); };

  SvgWriter svg{width, height, map.title,
                map.value_label + " over " + map.x_label + " and " + map.y_label + ", from " +
                    to_significant(range.low, digits) + " to " + to_significant(range.high, digits) + "."};
  svg.text({left, 0.5 * top}, shortened(map.title, title_size, width - left), {.size = title_size, .bold = true});
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      draw_cell(svg, map.values[row][column], range, {x_of(column), y_of(row)}, cell_width, cell_height);
  const std::size_t x_step = every(columns, cell_width, widest(map.x_values) + 10.0);
  for (std::size_t i = 0; i < columns; i += x_step)
    svg.text({x_of(i) + 0.5 * cell_width, floor + 5.0 + 0.5 * tick_size},
             shortened(map.x_values[i], tick_size, cell_width * static_cast<double>(x_step)),
             {.size = tick_size, .anchor = "middle"});
  for (std::size_t i = 0; i < rows; i += every(rows, cell_height, tick_size + 4.0))
    svg.text({left - 6.0, y_of(i) + 0.5 * cell_height}, shortened(map.y_values[i], tick_size, 0.3 * width),
             {.size = tick_size, .anchor = "end"});
  svg.text({0.5 * (left + width - right), floor + 5.0 + tick_size + 14.0}, map.x_label, {.anchor = "middle"});
  svg.text({18.0, 0.5 * (top + floor)}, shortened(map.y_label, label_size, floor - top),
           {.anchor = "middle", .upwards = true});
  draw_scale(svg, map, range, {width - right + scale_gap, top}, floor - top);
  return svg.finish();
}

}  // namespace moat
