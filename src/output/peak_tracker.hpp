// The largest magnitude of a quantity over continuous time.
#pragma once

#include <cmath>

#include "base/hermite.hpp"

namespace moat {

/// Follows one quantity through instants at unequal distances and keeps its largest magnitude over continuous time:
/// between two instants whose rates have opposite signs the cubic through values and rates turns, and its value there
/// counts. Quantities may jump at events; restart() keeps the cubic from reaching across.
///
/// Times are in s, rates per second.
class PeakTracker {
 public:
  /// `inside(fraction, value)` returns the value of the quantity at a fraction of the last step where the cubic has an
  /// extremum with the given value.
  template <class Inside>
  void add(double time, double value, double rate, const Inside& inside) {
    keep(time, value);
    if (last_.rate * rate < 0.0) [[unlikely]]
      add_turn({time, value, rate}, inside);
    remember({time, value, rate});
  }
  void add(double time, double value, double rate) {
    add(time, value, rate, [](double, double turned) { return turned; });
  }

  /// The value just after an event.
  void restart(double time, double value, double rate) {
    keep(time, value);
    remember({time, value, rate});
  }

  /// The rate of the quantity jumps at a time inside the last step, and the value there may be a peak. It is
  /// extrapolated from both ends with the curvature of the step before; the nearer end has the larger weight.
  void add_bend(double time) {
    const double from_start = time - start_.time, to_end = last_.time - time, step = last_.time - start_.time;
    if (from_start <= 0.0 || to_end <= 0.0) return;
    const double earlier_step = start_.time - earlier_time_;
    const double curvature = earlier_step > 0.0 ? (start_.rate - earlier_rate_) / earlier_step : 0.0;
    const double forward = start_.value + from_start * (start_.rate + 0.5 * curvature * from_start);
    const double backward = last_.value - to_end * (last_.rate - 0.5 * curvature * to_end);
    keep(time, (to_end * forward + from_start * backward) / step);
  }

  /// The value with the largest magnitude, the first of equal ones; 0 if there is none.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double magnitude() const { return std::abs(value_); }
  /// When value() was reached, s.
  [[nodiscard]] double time() const { return time_; }

 private:
  struct Instant {
    double time = 0.0, value = 0.0, rate = 0.0;
  };

  template <class Inside>
  void add_turn(const Instant& now, const Inside& inside) {
    const double step = now.time - last_.time;
    if (step <= 0.0) return;
    const HermiteCubic cubic{last_.value, last_.rate, now.value, now.rate, step};
    const double x = cubic.turn();
    const double turned = cubic.value(x);
    if (cubic.is_smooth() && std::abs(turned) > magnitude()) keep(last_.time + x * step, inside(x, turned));
  }
  void keep(double time, double value) {
    if (std::abs(value) <= magnitude()) [[likely]]
      return;
    value_ = value;
    time_ = time;
  }
  void remember(const Instant& now) {
    earlier_time_ = start_.time;
    earlier_rate_ = start_.rate;
    start_ = last_;
    last_ = now;
  }

  double value_ = 0.0, time_ = 0.0;
  Instant last_, start_;  // the ends of the last step; without a rate at first, so that nothing turns
  double earlier_time_ = 0.0, earlier_rate_ = 0.0;
};

}  // namespace moat
