// The largest magnitudes of many quantities over continuous time.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "output/peak_tracker.hpp"

namespace moat {

/// Many quantities at an instant.
struct CommonInstant {
  double time = 0.0;           ///< s
  std::vector<double> values;  ///< each in its unit
  std::vector<double> rates;   ///< per second
};

/// Follows many quantities through common instants, each of them as PeakTracker does. The caller fills next() and then
/// calls add() or restart().
class PeakTrackers {
 public:
  /// `count` quantities.
  explicit PeakTrackers(std::size_t count) : values_(count), times_(count) {
    // Without rates at first, so that nothing turns.
    for (CommonInstant& instant : instants_) instant = {0.0, std::vector<double>(count), std::vector<double>(count)};
  }

  /// The number of quantities.
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  /// For the caller to fill, with as many values and rates as quantities.
  [[nodiscard]] CommonInstant& next() { return instants_[(newest_ + 1) % kept]; }
  [[nodiscard]] const CommonInstant& last() const { return before(0); }   ///< The end of the last step.
  [[nodiscard]] const CommonInstant& start() const { return before(1); }  ///< Its start.

  /// The values of next(), at the end of a step. `inside(quantity, fraction, value)` is as for find_turn().
  template <class Inside>
  void add(const Inside& inside) {
    ++newest_;
    const CommonInstant &from = start(), &to = last();
    const double *value = to.values.data(), *rate = to.rates.data(), *rate_before = from.rates.data(),
                 *peak = values_.data();
    const std::size_t count = size();  // read once: the compiler cannot know that keep() leaves it
    for (std::size_t i = 0; i < count; ++i) {
      if (std::abs(value[i]) > std::abs(peak[i])) [[unlikely]]
        keep(i, to.time, value[i]);
      if (rate_before[i] * rate[i] < 0.0) [[unlikely]]
        find_turn(
            of(from, i), of(to, i), magnitude(i), [&](double x, double turned) { return inside(i, x, turned); },
            [&](double when, double turned) { keep(i, when, turned); });
    }
  }

  /// The values of next(), just after an event.
  void restart() {
    ++newest_;
    for (std::size_t i = 0; i < size(); ++i) keep(i, last().time, last().values[i]);
  }

  /// The rate of a quantity jumps at a time inside the last step, and the value there may be a peak. It is extrapolated
  /// from both ends with the curvature of the step before; the nearer end has the larger weight.
  void add_bend(std::size_t i, double time) {
    const Instant from = of(start(), i), to = of(last(), i), earlier = of(before(2), i);
    const double from_start = time - from.time, to_end = to.time - time, step = to.time - from.time;
    if (from_start <= 0.0 || to_end <= 0.0) return;
    const double earlier_step = from.time - earlier.time;
    const double curvature = earlier_step > 0.0 ? (from.rate - earlier.rate) / earlier_step : 0.0;
    const double forward = from.value + from_start * (from.rate + 0.5 * curvature * from_start);
    const double backward = to.value - to_end * (to.rate - 0.5 * curvature * to_end);
    keep(i, time, (to_end * forward + from_start * backward) / step);
  }

  /// A value of one quantity between the instants.
  void keep(std::size_t i, double time, double value) {
    if (std::abs(value) <= magnitude(i)) [[likely]]
      return;
    values_[i] = value;
    times_[i] = time;
  }

  /// The value with the largest magnitude, the first of equal ones; 0 if there is none.
  [[nodiscard]] double value(std::size_t i) const { return values_[i]; }
  [[nodiscard]] double magnitude(std::size_t i) const { return std::abs(values_[i]); }  ///< Of value().
  /// When value() was reached, s.
  [[nodiscard]] double time(std::size_t i) const { return times_[i]; }

 private:
  static constexpr std::size_t kept = 4;  // the next instant, both ends of the last step, and the instant before them

  [[nodiscard]] const CommonInstant& before(std::size_t steps) const { return instants_[(newest_ - steps) % kept]; }
  [[nodiscard]] static Instant of(const CommonInstant& instant, std::size_t i) {
    return {instant.time, instant.values[i], instant.rates[i]};
  }

  std::vector<double> values_, times_;
  std::array<CommonInstant, kept> instants_;
  std::size_t newest_ = kept;
};

}  // namespace moat
