// The largest magnitudes of many quantities over continuous time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

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

/// Many quantities at an instant.
struct CommonInstant {
  double time = 0.0;           ///< s
  std::vector<double> values;  ///< each in its unit
  std::vector<double> rates;   ///< per second

  void archive(auto& archive) { archive(time, values, rates); }  ///< StateArchive.
};

/// Follows many quantities through common instants at unequal distances and keeps the largest magnitude of each over
/// continuous time: between two instants whose rates have opposite signs the cubic through values and rates turns, and
/// its value there counts. Quantities may jump at events; restart() keeps the cubic from reaching across. The caller
/// fills next() and then calls add() or restart().
class PeakTrackers {
 public:
  /// `count` quantities. may_bend: whether add_bend() may be called, which takes instants further back.
  explicit PeakTrackers(std::size_t count, bool may_bend = true)
      : values_(count), times_(count), kept_{may_bend ? most_kept : 3} {
    if (may_bend) last_bends_.assign(count, -std::numeric_limits<double>::infinity());
    constexpr std::size_t most_turns_at_once = 1024;  // more are rare
    turns_.reserve(std::min(count, most_turns_at_once));
    // Without rates at first, so that nothing turns.
    for (std::size_t i = 0; i < kept_; ++i)
      instants_[i] = {0.0, std::vector<double>(count), std::vector<double>(count)};
  }

  /// The number of quantities.
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  /// For the caller to fill, with as many values and rates as quantities.
  [[nodiscard]] CommonInstant& next() { return instants_[(newest_ + 1) % kept_]; }
  [[nodiscard]] const CommonInstant& last() const { return before(0); }   ///< The end of the last step.
  [[nodiscard]] const CommonInstant& start() const { return before(1); }  ///< The start of the last step.

  /// The values of next(), at the end of a step. `inside(quantity, fraction, value)` is as for find_turn().
  template <class Inside>
  void add(const Inside& inside) {
    ++newest_;
    turns_.clear();
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
            [&](double when, double turned) { keep_in_turn(i, when, turned); });
    }
  }

  /// The values of next(), just after an event.
  void restart() {
    ++newest_;
    for (std::size_t i = 0; i < size(); ++i) keep(i, last().time, last().values[i]);
  }

  /// The rate of a quantity jumps at a time inside the last step. The cubic over that step does not follow the bend:
  /// where it turned does not count. The value at the bend counts, and where the paths before and behind it turn. Up to
  /// the bend the path is the cubic over the step before, continued, or over as many steps before as are long enough
  /// not to magnify round-off. If the quantity jumped or bent in these, or they are not known any more, the value is
  /// extrapolated along straight lines from both ends of the last step, the nearer one with the larger weight.
  void add_bend(std::size_t i, double time) {
    const Instant from = of(start(), i), to = of(last(), i);
    const double from_start = time - from.time, to_end = to.time - time;
    if (from_start <= 0.0 || to_end <= 0.0) return;
    take_back_turn(i);
    Instant bend{time, from.value + from_start * from.rate, from.rate};
    constexpr double farthest = 4.0;  // of the length of the steps before
    const Instant earlier = smooth_since(i, from_start / farthest);
    if (const double earlier_steps = from.time - earlier.time; farthest * earlier_steps > from_start) {
      const HermiteCubic path{earlier.value, earlier.rate, from.value, from.rate, earlier_steps};
      const double beyond = 1.0 + from_start / earlier_steps;
      bend = {time, path.value(beyond), path.rate(beyond)};
    } else {
      const double backward = to.value - to_end * to.rate;
      bend.value = (to_end * bend.value + from_start * backward) / (from_start + to_end);
    }
    last_bends_[i] = time;
    keep(i, time, bend.value);
    keep_turn(i, from, bend);
    // Behind the bend a parabola that meets value and rate at the end of the step.
    bend.rate = 2.0 * (to.value - bend.value) / to_end - to.rate;
    keep_turn(i, bend, to);
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
  [[nodiscard]] double magnitude(std::size_t i) const { return std::abs(values_[i]); }  ///< Magnitude of value().
  /// When value() was reached, s.
  [[nodiscard]] double time(std::size_t i) const { return times_[i]; }
  /// Writes or reads peaks and instants.
  void archive(auto& archive) { archive(values_, times_, last_bends_, turns_, instants_, newest_); }

 private:
  static constexpr std::size_t most_kept = 6;

  [[nodiscard]] const CommonInstant& before(std::size_t steps) const { return instants_[(newest_ - steps) % kept_]; }
  [[nodiscard]] static Instant of(const CommonInstant& instant, std::size_t i) {
    return {instant.time, instant.values[i], instant.rates[i]};
  }

  // The last known instant that is at least so much earlier than the start of the last step, or the earliest one, since
  // which a quantity has neither jumped nor bent.
  [[nodiscard]] Instant smooth_since(std::size_t i, double earlier) const {
    constexpr double round_off = 1e-5;  // of the peak
    const double start_time = start().time;
    Instant known = of(start(), i);
    for (std::size_t steps = 2; steps < kept_ - 1 && start_time - known.time <= earlier; ++steps) {
      const Instant before_it = of(before(steps), i);
      const double jump = std::abs(before_it.value - known.value) + earlier * std::abs(before_it.rate - known.rate);
      const bool jumped = before_it.time == known.time && jump > round_off * magnitude(i);
      if (jumped || last_bends_[i] > before_it.time) break;
      known = before_it;
    }
    return known;
  }

  // A peak inside the last step that replaced another one.
  struct Turn {
    std::size_t quantity;
    double replaced_value, replaced_time;
  };
  void keep_in_turn(std::size_t i, double time, double value) {
    turns_.push_back({i, values_[i], times_[i]});
    keep(i, time, value);
  }
  void take_back_turn(std::size_t i) {
    const auto turn = std::ranges::find(turns_, i, &Turn::quantity);
    if (turn == turns_.end()) return;
    values_[i] = turn->replaced_value;
    times_[i] = turn->replaced_time;
    turns_.erase(turn);
  }
  void keep_turn(std::size_t i, const Instant& from, const Instant& to) {
    if (from.rate * to.rate < 0.0)
      find_turn(
          from, to, magnitude(i), [](double, double turned) { return turned; },
          [&](double when, double turned) { keep(i, when, turned); });
  }

  std::vector<double> values_, times_;
  std::vector<double> last_bends_;  // s; empty where nothing bends
  std::vector<Turn> turns_;         // of the last step
  std::size_t kept_;                // instants: the next one, both ends of the last step, and three before them
  std::array<CommonInstant, most_kept> instants_;
  std::size_t newest_ = most_kept;
};

}  // namespace moat
