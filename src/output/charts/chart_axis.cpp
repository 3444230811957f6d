#include "output/charts/chart_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/number_format.hpp"
#include "output/charts/chart_style.hpp"
#include "output/charts/text_width.hpp"

namespace moat {
namespace {

using Range = std::pair<double, double>;

// Round-off of a computed tick, relative to the distance of two.
constexpr double round_off = 1e-9;
// From here on and below, labels have an exponent.
constexpr double large = 1e6, small = 1e-4;

/// 1, 2, 5 times a power of ten.
double nearest_round_step(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step)));
  const double share = step / decade;
  // Geometric means of neighbours.
  if (share < std::sqrt(2.0)) return decade;
  if (share < std::sqrt(10.0)) return 2.0 * decade;
  if (share < std::sqrt(50.0)) return 5.0 * decade;
  return 10.0 * decade;
}

double next_round_step(double step) { return nearest_round_step(2.2 * step); }

/// "1.5e8", "-3e-7": without the signs and zeros that say nothing.
std::string with_exponent(double value, int exponent, int decimals) {
  return to_fixed(value / std::pow(10.0, exponent), decimals) + "e" + std::to_string(exponent);
}

std::string with_minus_sign(std::string label) {
  if (label.starts_with('-')) label.replace(0, 1, "\u2212");
  return label;
}

/// Every tick of an axis has as many decimals as the step needs.
std::string linear_label(double value, double step, double largest) {
  if (std::abs(value) < round_off * step) return "0";
  const int place = static_cast<int>(std::floor(std::log10(step) + round_off));
  if (largest < large && step >= small) return with_minus_sign(to_fixed(value, std::max(0, -place)));
  const int exponent = static_cast<int>(std::floor(std::log10(largest) + round_off));
  return with_minus_sign(with_exponent(value, exponent, std::max(0, exponent - place)));
}

std::string logarithmic_label(double value) {
  if (value < large && value > small) return to_significant(value, 6);
  const int exponent = static_cast<int>(std::floor(std::log10(value) + round_off));
  return with_exponent(value, exponent, 0);
}

std::vector<AxisTick> linear_ticks(Range range, double step) {
  std::vector<AxisTick> ticks;
  const double largest = std::max(std::abs(range.first), std::abs(range.second));
  const double first = std::ceil(range.first / step - round_off), last = std::floor(range.second / step + round_off);
  for (int i = 0; i <= static_cast<int>(last - first); ++i)
    ticks.push_back({(first + i) * step, linear_label((first + i) * step, step, largest)});
  return ticks;
}

/// Powers of ten, each one or every second ..., or with 2 and 5 times them.
std::vector<AxisTick> logarithmic_ticks(Range range, int decades, bool with_parts) {
  std::vector<AxisTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.first) + round_off));
  const int last = static_cast<int>(std::floor(std::log10(range.second) + round_off));
  for (int decade = first; decade <= last; ++decade)
    for (const double part : {1.0, 2.0, 5.0}) {
      if ((part > 1.0 && !with_parts) || decade % decades != 0) continue;
      const double value = part * std::pow(10.0, decade);
      if (value < range.first * (1.0 - round_off) || value > range.second * (1.0 + round_off)) continue;
      ticks.push_back({value, logarithmic_label(value)});
    }
  return ticks;
}

/// The lowest and highest of 1, 2, 5 times a power of ten that hold both ends.
Range round_logarithmic_range(Range range) {
  const auto round_value = [](double value, bool up) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    constexpr std::array parts{1.0, 2.0, 5.0, 10.0};
    double below = decade;
    for (const double part : parts) {
      if (part * decade <= value * (1.0 + round_off)) below = part * decade;
      if (part * decade >= value * (1.0 - round_off) && up) return part * decade;
    }
    return below;
  };
  const double low = round_value(range.first, false), high = round_value(range.second, true);
  return {low, high > low ? high : 10.0 * low};
}

/// A range that is not empty.
Range widened(Range range) {
  const double largest = std::max(std::abs(range.first), std::abs(range.second));
  constexpr double too_small = 1e-290;  // for a step between ticks
  if (largest < too_small) return {-1.0, 1.0};
  if (range.second - range.first > round_off * largest) return range;
  return {std::min(0.0, 1.2 * range.first), std::max(0.0, 1.2 * range.second)};
}

bool labels_fit(const ChartAxis& axis, AxisSide side, double length) {
  const auto size = [&](const AxisTick& tick) {
    return side == AxisSide::left ? chart_style::tick_size : text_width(tick.label, chart_style::tick_size);
  };
  constexpr double distance = 8.0;
  for (std::size_t i = 1; i < axis.ticks.size(); ++i) {
    const AxisTick &one = axis.ticks[i - 1], &two = axis.ticks[i];
    if (length * (axis.share(two.value) - axis.share(one.value)) < 0.5 * (size(one) + size(two)) + distance)
      return false;
  }
  return true;
}

ChartAxis logarithmic_axis(Range range, AxisSide side, double length) {
  ChartAxis axis{range.first, range.second, true};
  axis.ticks = logarithmic_ticks(range, 1, true);
  constexpr double parts_of_short_axis = 4.0;
  if (axis.ticks.size() < 2)
    axis.ticks = linear_ticks(range, nearest_round_step((range.second - range.first) / parts_of_short_axis));
  for (int decades = 1; !labels_fit(axis, side, length); ++decades)
    axis.ticks = logarithmic_ticks(range, decades, false);
  return axis;
}

ChartAxis linear_axis(Range range, bool to_round_ends, AxisSide side, double length) {
  const double pixels_per_tick = side == AxisSide::left ? 40.0 : 90.0;
  const double span = range.second - range.first;
  double step = nearest_round_step(span * std::min(0.5, pixels_per_tick / length));
  while (true) {
    ChartAxis axis{range.first, range.second};
    if (to_round_ends) {
      axis.low = step * std::floor(range.first / step + round_off);
      axis.high = step * std::ceil(range.second / step - round_off);
    }
    axis.ticks = linear_ticks({axis.low, axis.high}, step);
    if (axis.ticks.size() <= 2 || labels_fit(axis, side, length)) return axis;
    if (step > span) {
      // Both ends show a scale, however long their labels.
      axis.ticks = {axis.ticks.front(), axis.ticks.back()};
      return axis;
    }
    step = next_round_step(step);
  }
}

}  // namespace

double ChartAxis::share(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

ChartAxis axis_over(Range range, bool logarithmic, AxisSide side, double length) {
  return logarithmic ? logarithmic_axis(range, side, length) : linear_axis(range, false, side, length);
}

ChartAxis axis_around(Range range, bool logarithmic, AxisSide side, double length) {
  return logarithmic ? logarithmic_axis(round_logarithmic_range(range), side, length)
                     : linear_axis(widened(range), true, side, length);
}

}  // namespace moat
