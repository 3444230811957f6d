#include "output/charts/chart_axis.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/number_format.hpp"
#include "output/charts/svg_writer.hpp"

namespace moat {
namespace {

using Range = std::pair<double, double>;

// Round-off of a computed tick, relative to the distance of two.
constexpr double round_off = 1e-9;

int decade_of(double value) { return static_cast<int>(std::floor(std::log10(value) + round_off)); }

double next_round_number(double round) { return round_number_below(2.6 * round); }

/// Every tick of an axis has as many decimals as the step needs. Large and small numbers have an exponent.
std::string label_of(double value, double step, double largest) {
  constexpr double large = 1e6, small = 1e-4;
  if (std::abs(value) < round_off * step) return "0";
  const bool plain = largest < large && step >= small;
  const int exponent = plain ? 0 : decade_of(largest);
  std::string label = to_fixed(value / std::pow(10.0, exponent), std::max(0, exponent - decade_of(step))) +
                      (plain ? "" : "e" + std::to_string(exponent));
  if (label.starts_with('-')) label.replace(0, 1, "\u2212");
  return label;
}

std::vector<AxisTick> linear_ticks(Range range, double step) {
  std::vector<AxisTick> ticks;
  const double largest = std::max(std::abs(range.first), std::abs(range.second));
  const double first = std::ceil(range.first / step - round_off), last = std::floor(range.second / step + round_off);
  for (int i = 0; i <= static_cast<int>(last - first); ++i)
    ticks.push_back({(first + i) * step, label_of((first + i) * step, step, largest)});
  return ticks;
}

/// 1, 2, 5 times the powers of ten; where these are too many, each power, each second one ...
std::vector<AxisTick> logarithmic_ticks(Range range, int every) {
  std::vector<AxisTick> ticks;
  for (int decade = decade_of(range.first); decade <= decade_of(range.second); ++decade)
    for (const double part : {1.0, 2.0, 5.0}) {
      const double value = part * std::pow(10.0, decade);
      const bool inside = value >= range.first * (1.0 - round_off) && value <= range.second * (1.0 + round_off);
      const bool wanted = every == 0 || (part == 1.0 && decade % every == 0);
      if (inside && wanted) ticks.push_back({value, label_of(value, value, value)});
    }
  return ticks;
}

bool labels_fit(const ChartAxis& axis, AxisSide side, double length) {
  const auto size = [&](const AxisTick& tick) {
    return side == AxisSide::left ? chart_style::tick_size : text_width(tick.label, chart_style::tick_size);
  };
  constexpr double distance = 8.0;
  return std::ranges::adjacent_find(axis.ticks, [&](const AxisTick& one, const AxisTick& two) {
           return length * (axis.share(two.value) - axis.share(one.value)) < 0.5 * (size(one) + size(two)) + distance;
         }) == axis.ticks.end();
}

ChartAxis logarithmic_axis(Range range, AxisSide side, double length) {
  ChartAxis axis{range.first, range.second, true};
  int every = 0;
  do axis.ticks = logarithmic_ticks(range, every++);
  while (!labels_fit(axis, side, length));
  constexpr double parts_of_short_axis = 4.0;
  if (axis.ticks.size() < 2)
    axis.ticks = linear_ticks(range, round_number_below((range.second - range.first) / parts_of_short_axis));
  return axis;
}

ChartAxis linear_axis(Range range, bool to_round_ends, AxisSide side, double length) {
  const double pixels_per_tick = side == AxisSide::left ? 40.0 : 90.0, span = range.second - range.first;
  double step = round_number_below(std::sqrt(2.0) * span * std::min(0.5, pixels_per_tick / length));
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
    step = next_round_number(step);
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
  const auto [low, high] = range;
  if (logarithmic) {
    constexpr double just_below = 1.0 - 1e-6;
    const double first = round_number_below(low), last = next_round_number(round_number_below(just_below * high));
    return logarithmic_axis({first, last > first ? last : 10.0 * first}, side, length);
  }
  // A range that is not empty, and not too small for a step between ticks.
  const double largest = std::max(std::abs(low), std::abs(high));
  constexpr double too_small = 1e-290;
  if (largest < too_small)
    range = {-1.0, 1.0};
  else if (high - low <= round_off * largest)
    range = {std::min(0.0, 1.2 * low), std::max(0.0, 1.2 * high)};
  return linear_axis(range, true, side, length);
}

double round_number_below(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double part : {10.0, 5.0, 2.0})
    if (part * decade <= value * (1.0 + round_off)) return part * decade;
  return decade;
}

}  // namespace moat
