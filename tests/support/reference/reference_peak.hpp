// The largest magnitude of a quantity whose values and rates are known at the ends of short steps.
#pragma once

#include <algorithm>
#include <cmath>

namespace moat::testing {

/// The cubic through value and rate at both ends of a step.
struct HermiteCubic {
  double step, start, start_rate, end, end_rate;

  [[nodiscard]] double at(double x) const {
    const double rise = end - start, left = step * start_rate - rise, right = rise - step * end_rate;
    return start + x * rise + x * (1.0 - x) * ((1.0 - x) * left + x * right);
  }
  /// Fraction of the step at which it turns, between 0 and 1: the rates at the ends must have opposite signs.
  [[nodiscard]] double turn() const {
    // The slope is a parabola a + 2 b x + c x^2 with a zero between 0 and 1.
    const double a = step * start_rate, rise = end - start;
    const double b = 3.0 * rise - 2.0 * a - step * end_rate, c = 3.0 * (a + step * end_rate - 2.0 * rise);
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    // The zero where the slope goes from the sign of `a` to the other.
    const double x = a > 0.0 ? a / (root - b) : -a / (root + b);
    return std::clamp(x, 0.0, 1.0);
  }
  /// Its value there, but not beyond the point in which the lines through both ends meet: a curve that bends one way
  /// stays within. Where a rate is nearly infinite, like that of d^1/4 behind a touch, the cubic would leave it far
  /// behind.
  [[nodiscard]] double turned() const {
    const double a = step * start_rate, b = step * end_rate;
    const double meeting = start + a * std::clamp((end - start - b) / (a - b), 0.0, 1.0), value = at(turn());
    return a > 0.0 ? std::min(value, std::max({meeting, start, end}))
                   : std::max(value, std::min({meeting, start, end}));
  }
};

/// Largest magnitude over continuous time. A step is so short that a quantity turns at most once within it.
struct ReferencePeakTracker {
  double magnitude = 0.0, time = 0.0;

  void keep(double value, double at) {
    if (std::abs(value) <= magnitude) return;
    magnitude = std::abs(value);
    time = at;
  }
  void add_step(double from, const HermiteCubic& cubic) {
    keep(cubic.start, from);
    keep(cubic.end, from + cubic.step);
    if (!(cubic.start_rate * cubic.end_rate < 0.0)) return;
    keep(cubic.turned(), from + cubic.turn() * cubic.step);
  }
};

}  // namespace moat::testing
