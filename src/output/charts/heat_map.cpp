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
#include "output/charts/chart_style.hpp"
#include "output/charts/svg_writer.hpp"
#include "output/charts/text_width.hpp"
#include "output/files/file_io.hpp"

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

struct Colour {
  double red, green, blue;
};
// Colours of viridis at equal distances.
constexpr std::array<Colour, 9> viridis{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};

Colour colour_at(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double part = place - static_cast<double>(below);
  const Colour &a = viridis[below], &b = viridis[below + 1];
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green), a.blue + part * (b.blue - a.blue)};
}

std::string text_of(const Colour& colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(std::lround(colour.red)) & 255u,
                static_cast<unsigned>(std::lround(colour.green)) & 255u,
                static_cast<unsigned>(std::lround(colour.blue)) & 255u);
  return text.data();
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  [[nodiscard]] double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Range checked_range(const HeatMap& map, int width, int height) {
  const Check check{"HeatMap", map.title};
  check.that(width >= 300, "width", width, "pixels", ">= 300 pixels");
  check.that(height >= 200, "height", height, "pixels", ">= 200 pixels");
  check.that(!map.x_values.empty() && !map.y_values.empty(), "there are no cells.", "Give x_values and y_values.");
  check.that(map.values.size() == map.y_values.size(), "the numbers of rows and of y_values differ.",
             "Give one name for every row.");
  Range range;
  for (const std::vector<double>& row : map.values) {
    check.that(row.size() == map.x_values.size(), "the numbers of columns and of x_values differ.",
               "Give one name for every column.");
    for (const double value : row) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  check.that(range.low <= range.high, "there is no value to draw.", "Give at least one that is finite.");
  return range;
}

/// Every how many names fit without overlapping.
std::size_t every(const std::vector<std::string>& names, double room_for_each, double most) {
  const double steps = std::ceil(most / std::max(room_for_each, 1.0));
  return std::clamp<std::size_t>(static_cast<std::size_t>(steps), 1, names.size());
}

void draw_scale(SvgWriter& svg, const HeatMap& map, const Range& range, Pixel corner, double height) {
  constexpr int bands = 64;
  for (int i = 0; i < bands; ++i)
    svg.rectangle({corner.x, corner.y + height * (bands - 1 - i) / bands}, scale_width, height / bands + 0.5,
                  text_of(colour_at((i + 0.5) / bands)));
  if (range.high > range.low) {
    const ChartAxis axis = axis_over({range.low, range.high}, false, AxisSide::left, height);
    for (const AxisTick& tick : axis.ticks)
      svg.text({corner.x + scale_width + 5.0, corner.y + height * (1.0 - axis.share(tick.value))}, tick.label,
               {.size = tick_size});
  } else {
    svg.text({corner.x + scale_width + 5.0, corner.y + 0.5 * height}, to_significant(range.low, digits),
             {.size = tick_size});
  }
  svg.text({corner.x + right - scale_gap - 14.0, corner.y + 0.5 * height},
           shortened(map.value_label, label_size, height),
           {.size = label_size, .anchor = Lettering::Anchor::middle, .upwards = true});
}

}  // namespace

std::string svg_text(const HeatMap& map, int width, int height) {
  const Range range = checked_range(map, width, height);
  double widest_y = 0.0, widest_x = 0.0;
  for (const std::string& name : map.y_values) widest_y = std::max(widest_y, text_width(name, tick_size));
  for (const std::string& name : map.x_values) widest_x = std::max(widest_x, text_width(name, tick_size));
  const double left = 44.0 + std::min(widest_y, 0.3 * width);
  const double cell_width = (width - left - right) / static_cast<double>(map.x_values.size());
  const double cell_height = (height - top - bottom) / static_cast<double>(map.y_values.size());
  const double floor = height - bottom;

  SvgWriter svg{width, height, map.title,
                map.value_label + " over " + map.x_label + " and " + map.y_label + ", from " +
                    to_significant(range.low, digits) + " to " + to_significant(range.high, digits) + "."};
  svg.text({left, 0.5 * top}, shortened(map.title, title_size, width - left), {.size = title_size, .bold = true});
  for (std::size_t row = 0; row < map.values.size(); ++row)
    for (std::size_t column = 0; column < map.x_values.size(); ++column) {
      const double value = map.values[row][column];
      const Pixel corner{left + cell_width * static_cast<double>(column),
                         floor - cell_height * static_cast<double>(row + 1)};
      // Cells overlap by a little, so that no line shows between them.
      svg.rectangle(corner, cell_width + 0.3, cell_height + 0.3,
                    std::isfinite(value) ? text_of(colour_at(range.share(value))) : no_value);
      const std::string number = std::isfinite(value) ? cell_number(value) : "";
      constexpr double plate_margin = 3.0, plate_height = 16.0;
      const double room = text_width(number, tick_size) + 4.0 * plate_margin;
      if (number.empty() || room > cell_width || plate_height + plate_margin > cell_height) continue;
      const Pixel middle{corner.x + 0.5 * cell_width, corner.y + 0.5 * cell_height};
      svg.rectangle({middle.x - 0.5 * room + plate_margin, middle.y - 0.5 * plate_height}, room - 2.0 * plate_margin,
                    plate_height, paper);
      svg.text(middle, number, {.size = tick_size, .anchor = Lettering::Anchor::middle, .on_paper = true});
    }
  const std::size_t x_step = every(map.x_values, cell_width, widest_x + 10.0);
  for (std::size_t i = 0; i < map.x_values.size(); i += x_step)
    svg.text({left + cell_width * (static_cast<double>(i) + 0.5), floor + 5.0 + 0.5 * tick_size},
             shortened(map.x_values[i], tick_size, cell_width * static_cast<double>(x_step)),
             {.size = tick_size, .anchor = Lettering::Anchor::middle});
  const std::size_t y_step = every(map.y_values, cell_height, tick_size + 4.0);
  for (std::size_t i = 0; i < map.y_values.size(); i += y_step)
    svg.text({left - 6.0, floor - cell_height * (static_cast<double>(i) + 0.5)},
             shortened(map.y_values[i], tick_size, 0.3 * width), {.size = tick_size, .anchor = Lettering::Anchor::end});
  const Lettering label{.size = label_size, .anchor = Lettering::Anchor::middle};
  svg.text({0.5 * (left + width - right), floor + 5.0 + tick_size + 14.0}, map.x_label, label);
  svg.text({18.0, 0.5 * (top + floor)}, shortened(map.y_label, label_size, floor - top),
           {.size = label_size, .anchor = Lettering::Anchor::middle, .upwards = true});
  draw_scale(svg, map, range, {width - right + scale_gap, top}, floor - top);
  return svg.finish();
}

void write_svg(const HeatMap& map, const std::filesystem::path& path, int width, int height) {
  write_file(path, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_text(map, width, height));
}

}  // namespace moat
