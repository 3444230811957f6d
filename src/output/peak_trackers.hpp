// The largest magnitudes of many quantities over continuous time.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/hermite.hpp"

namespace moat {

/// Many PeakTrackers that see the same instants: the same peaks to the last bit, several quantities at a time. Nearly
/// all samples of nearly all quantities are neither larger than everything before nor behind a turn, and of those only
/// the last value and rate are kept.
class PeakTrackers {
 public:
  explicit PeakTrackers(std::size_t count);

  /// One value and rate per quantity. `inside(i, fraction, value)` is asked for the value of quantity i that counts at
  /// a fraction of the last step, where the cubic through values and rates turns with the given value.
  template <class Inside>
  void add(double time, const double* values, const double* rates, const Inside& inside) {
    notable_.clear();
    find_notable(values, rates);
    const double step = time - time_before_;
    for (const std::size_t i : notable_) {
      keep(i, time, values[i]);
      if (!known_ || step <= 0.0 || rates_before_[i] * rates[i] >= 0.0) continue;
      const HermiteCubic cubic{values_before_[i], rates_before_[i], values[i], rates[i], step};
      const double x = cubic.turn();
      const double turned = cubic.value(x);
      if (cubic.is_smooth() && std::abs(turned) > magnitudes_[i])
        keep(i, time_before_ + x * step, inside(i, x, turned));
    }
    remember(time, values, rates);
  }
  void add(double time, const double* values, const double* rates) {
    add(time, values, rates, [](std::size_t, double, double turned) { return turned; });
  }
  /// Quantity i bends at a time inside the last step: its value there counts too, extrapolated from both ends with the
  /// curvature of the step before, the nearer end with the larger weight.
  void add_bend(std::size_t i, double time);
  /// The values just after an event.
  void restart(double time, const double* values, const double* rates) {
    known_ = false;
    add(time, values, rates);
  }

  [[nodiscard]] std::size_t size() const { return magnitudes_.size(); }
  [[nodiscard]] double magnitude(std::size_t i) const { return magnitudes_[i]; }
  [[nodiscard]] double time(std::size_t i) const { return times_[i]; }

 private:
  // Lists what may be a peak: values larger than all before, and turns.
  void find_notable(const double* values, const double* rates);
  void remember(double time, const double* values, const double* rates);
  void keep(std::size_t i, double time, double value) {
    if (std::abs(value) <= magnitudes_[i]) return;
    magnitudes_[i] = std::abs(value);
    times_[i] = time;
  }

  std::vector<double> magnitudes_, times_;
  std::vector<double> values_before_, rates_before_;  // at the last instant
  std::vector<double> start_values_, start_rates_;    // at the one before it
  std::vector<double> earlier_rates_;                 // and before that
  double time_before_ = 0.0, start_time_ = 0.0, earlier_time_ = 0.0;
  bool known_ = false;
  std::vector<std::size_t> notable_;
};

}  // namespace moat
