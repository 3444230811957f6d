// The largest magnitude of a quantity over continuous time.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/hermite.hpp"

namespace moat {

/// A quantity at an instant.
struct Instant {
  double time = 0.0;   ///< s
  double value = 0.0;  ///< in the unit of the quantity
  double rate = 0.0;   ///< per second
};

/// A bound of the magnitude of the cubic through two instants.
inline double reach_of_cubic(const Instant& start, const Instant& end) {
  return std::max(std::abs(start.value), std::abs(end.value)) +
         cubic_beyond_ends * (end.time - start.time) * (std::abs(start.rate) + std::abs(end.rate));
}

/// Where the cubic through two instants turns: calls found(time, value) if a peak there may exceed `magnitude`.
/// `inside(fraction, value)` returns the value of the quantity at a fraction of the step where the cubic has an
/// extremum with the given value.
template <class Inside, class Found>
void find_turn(const Instant& start, const Instant& end, double magnitude, const Inside& inside, const Found& found) {
  const double step = end.time - start.time;
  if (step <= 0.0 || reach_of_cubic(start, end) <= magnitude) return;
  const HermiteCubic cubic{start.value, start.rate, end.value, end.rate, step};
  const double x = cubic.turn();
  const double turned = cubic.value(x);
  if (cubic.is_smooth() && std::abs(turned) > magnitude) found(start.time + x * step, inside(x, turned));
}

/// Follows one quantity through instants at unequal distances and keeps its largest magnitude over continuous time:
/// between two instants whose rates have opposite signs the cubic through values and rates turns, and its value there
/// counts. Quantities may jump at events; restart() keeps the cubic from reaching across.
///
/// Times are in s, rates per second. PeakTrackers follows many quantities at common instants.
class PeakTracker {
 public:
  /// `inside` as for find_turn().
  template <class Inside>
  void add(double time, double value, double rate, const Inside& inside) {
    const Instant now{time, value, rate};
    keep(time, value);
    if (last_.rate * rate < 0.0)
      find_turn(last_, now, magnitude(), inside, [this](double when, double turned) { keep(when, turned); });
    last_ = now;
  }
  /// As above, where a cubic between two calls is exact.
  void add(double time, double value, double rate) {
    add(time, value, rate, [](double, double turned) { return turned; });
  }

  /// The value just after an event.
  void restart(double time, double value, double rate) {
    keep(time, value);
    last_ = {time, value, rate};
  }

  /// The value with the largest magnitude, the first of equal ones; 0 if there is none.
  [[nodiscard]] double value() const { return value_; }
  /// Magnitude of the peak, >= 0.
  [[nodiscard]] double magnitude() const { return std::abs(value_); }
  /// When value() was reached, s.
  [[nodiscard]] double time() const { return time_; }

 private:
  void keep(double time, double value) {
    if (std::abs(value) <= magnitude()) return;
    value_ = value;
    time_ = time;
  }

  double value_ = 0.0, time_ = 0.0;
  Instant last_;  // without a rate at first, so that nothing turns
};

}  // namespace moat
