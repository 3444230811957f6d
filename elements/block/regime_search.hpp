// Where inside a step a law changes its regime.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace moat {

/// The point from 0 to `beyond` <= 1 at which a function falls to `aim`, taken on the far side of the root. `beyond` if
/// the function stays above `aim`, 0 if it starts at or below `aim`.
///
/// The regula falsi called Illinois: the straight line through both ends of the bracket, where the value at an end that
/// stays twice is halved. Written here, because the functions are a few operations, and calls of them through a
/// std::function, as bracket_root() makes them, would be most of the search.
template <class Function>
double first_fall(const Function& function, double beyond, double aim) {
  constexpr double close = 1e-15;
  constexpr int evaluations_by_lines = 20, most_evaluations = 100;
  double low = 0.0, high = beyond, at_high = function(beyond) - aim;
  if (at_high >= 0.0) return beyond;
  double at_low = function(0.0) - aim;
  if (at_low <= 0.0) return 0.0;
  enum { none, at_the_low_end, at_the_high_end } last = none;  // where the bracket was narrowed
  for (int count = 0; high - low > close && count < most_evaluations; ++count) {
    double x = high + at_high * (high - low) / (at_low - at_high);
    if (count >= evaluations_by_lines || !std::isfinite(x)) x = 0.5 * (low + high);
    // Not at an end, so that the bracket closes from both sides.
    x = std::clamp(x, low + 0.5 * close, high - 0.5 * close);
    const double value = function(x) - aim;
    if (value > 0.0) {
      low = x;
      at_low = value;
      if (last == at_the_low_end) at_high *= 0.5;
      last = at_the_low_end;
    } else {
      high = x;
      at_high = value;
      if (last == at_the_high_end) at_low *= 0.5;
      last = at_the_high_end;
    }
  }
  return high;
}

/// The time, s, near 0 at which a function of time falls through zero: Newton's method with differences. Infinite if
/// the function does not fall at 0.
template <class Function>
double fall_near(const Function& function) {
  constexpr double apart = 1e-6, close = 1e-15;  // s
  constexpr int most_corrections = 8;
  double before = 0.0, at_before = function(before), time = apart, value = function(time);
  if (!(value < at_before)) return std::numeric_limits<double>::infinity();
  for (int count = 0; count < most_corrections && value != at_before; ++count) {
    const double next = time - value * (time - before) / (value - at_before);
    before = time;
    at_before = value;
    time = next;
    if (std::abs(time - before) <= close) break;
    value = function(time);
  }
  return time;
}

}  // namespace moat
