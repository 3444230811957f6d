// The largest magnitude of a quantity over continuous time.
#pragma once

#include <cmath>

#include "base/hermite.hpp"

namespace moat {

/// Follows one quantity through instants at unequal distances and keeps its largest magnitude over continuous time:
/// between two instants whose rates have opposite signs the cubic through values and rates turns, and its value there
/// counts. Quantities may jump at events; restart() keeps the cubic from reaching across.
class PeakTracker {
 public:
  /// Value and rate (per second) at a time in s. `inside(fraction, value)` is asked for the value that counts at a
  /// fraction of the last step, where the cubic turns with the given value.
  template <class Inside>
  void add(double time, double value, double rate, const Inside& inside) {
    keep(time, value);
    const double step = time - time_before_;
    if (known_ && step > 0.0 && rate_before_ * rate < 0.0) {
      const HermiteCubic cubic{value_before_, rate_before_, value, rate, step};
      const double x = cubic.turn();
      const double turned = cubic.value(x);
      if (cubic.is_smooth() && std::abs(turned) > magnitude_) keep(time_before_ + x * step, inside(x, turned));
    }
    known_ = true;
    time_before_ = time;
    value_before_ = value;
    rate_before_ = rate;
  }
  void add(double time, double value, double rate) {
    add(time, value, rate, [](double, double turned) { return turned; });
  }

  /// The value just after an event.
  void restart(double time, double value, double rate) {
    known_ = false;
    add(time, value, rate);
  }

  [[nodiscard]] double magnitude() const { return magnitude_; }
  [[nodiscard]] double time() const { return time_; }

 private:
  void keep(double time, double value) {
    if (std::abs(value) <= magnitude_) return;
    magnitude_ = std::abs(value);
    time_ = time;
  }

  double magnitude_ = 0.0, time_ = 0.0;
  double time_before_ = 0.0, value_before_ = 0.0, rate_before_ = 0.0;
  bool known_ = false;
};

}  // namespace moat
