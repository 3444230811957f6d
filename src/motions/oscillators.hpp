// Linear oscillators on a shaken support, several at once. Included by .cpp files alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hermite.hpp"

namespace moat {

/// Oscillators in one group: a processor computes several numbers at once.
inline constexpr int oscillators_per_group = 4;
/// One number of each oscillator of a group.
using OscillatorNumbers = Eigen::Array<double, oscillators_per_group, 1>;

/// How many steps an oscillator of this period takes in an interval, both in s. Peaks between steps come from a cubic,
/// which errs by (2 pi / 32)^4 / 384 = 4e-6 of the vibration.
inline double oscillator_steps(double period, double interval) {
  constexpr double steps_per_period = 32.0;
  return std::max(1.0, std::ceil(steps_per_period * interval / period));
}

/// Oscillators with one damping ratio on a support with the acceleration a:
///
///     u'' + 2 damping_ratio w u' + w^2 u = -a(t),   w = 2 pi / T
///
/// Their displacements relative to the support are followed as pseudo-accelerations w^2 u. `Numbers` is an array of
/// Eigen with an entry for each.
template <class Numbers>
struct Oscillators {
  Oscillators(const Numbers& of_periods, double ratio)
      : periods{of_periods},
        damping_ratio{ratio},
        frequency{2.0 * std::numbers::pi / periods},
        decay{ratio * frequency},
        damped_frequency{frequency * std::sqrt(1.0 - ratio * ratio)},
        damped_time{1.0 / damped_frequency},
        delay{2.0 * ratio / frequency} {}

  Numbers periods;                             ///< s
  double damping_ratio;                        ///< Share of critical damping.
  Numbers frequency, decay, damped_frequency;  ///< 1/s
  Numbers damped_time;                         ///< s, 1/damped_frequency
  Numbers delay;                               ///< s, damping over stiffness

  /// The particular solution forced + rate * t follows a support whose acceleration falls by `rate` m/s^3 from this
  /// one.
  [[nodiscard]] Numbers forced(const auto& support, const auto& rate) const { return -(support + delay * rate); }
};
/// Oscillators in a group.
using OscillatorGroup = Oscillators<OscillatorNumbers>;

/// Pseudo-accelerations of oscillators with their rates.
template <class Numbers>
struct OscillatorState {
  Numbers value = Numbers::Zero(), rate = Numbers::Zero();
};

/// Free vibration over one step: values and rates at its end from those at its start.
template <class Numbers>
struct OscillatorStep {
  OscillatorStep(const Oscillators<Numbers>& of, double step) : length{step} {
    const Numbers fading = (-of.decay * step).exp();
    const Numbers cosine = fading * (of.damped_frequency * step).cos();
    value_from_rate = fading * (of.damped_frequency * step).sin() * of.damped_time;
    value_from_value = cosine + of.decay * value_from_rate;
    rate_from_value = -of.frequency.square() * value_from_rate;
    rate_from_rate = cosine - of.decay * value_from_rate;
  }

  /// The state at the end: of the free vibration, and of the particular solution forced + rate * t.
  [[nodiscard]] OscillatorState<Numbers> after(const OscillatorState<Numbers>& free, const Numbers& forced,
                                               const auto& rate) const {
    return {value_from_value * free.value + value_from_rate * free.rate + (forced + rate * length),
            rate_from_value * free.value + rate_from_rate * free.rate + rate};
  }

  double length;                                                               ///< s
  Numbers value_from_value, value_from_rate, rate_from_value, rate_from_rate;  ///< Factors.
};

/// An interval in which the acceleration of the support is linear, and its equal parts, which are short enough for the
/// shortest period of the group to find peaks between their ends.
struct OscillatorInterval {
  OscillatorInterval(const OscillatorGroup& group, double length)
      : parts{oscillator_steps(group.periods.minCoeff(), length)}, whole{group, length}, part{group, length / parts} {}

  double parts;                                   ///< >= 1
  OscillatorStep<OscillatorNumbers> whole, part;  ///< The whole interval and one part.
};

/// The motion of a group of oscillators from rest, and its largest values up to now: the exact solution for a linear
/// acceleration of the support (Nigam and Jennings, Bulletin of the Seismological Society of America 59(2), 1969).
class OscillatorMotion {
 public:
  /// Moves on by an interval, between two accelerations of the support, m/s^2. Absolute accelerations cost as much
  /// again.
  template <bool with_absolute>
  void pass(const OscillatorGroup& group, const OscillatorInterval& interval, double support_0, double support_1) {
    const double rate = (support_0 - support_1) / interval.whole.length;
    const OscillatorNumbers forced = group.forced(support_0, rate);
    const State free{motion_.value - forced, motion_.rate - rate};
    const State end = interval.whole.after(free, forced, rate);
    if (interval.parts == 1.0)
      raise_peaks<with_absolute>(group, motion_, end, support_0, support_1, interval.whole.length);
    else if (may_rise<with_absolute>(group, free, forced, forced + rate * interval.whole.length, support_0, support_1))
      follow_parts<with_absolute>(group, interval, support_0, rate);
    motion_ = end;
  }

  /// Vibrates freely on a support at rest, in such intervals, over the longest period: the largest values come within
  /// that.
  template <bool with_absolute>
  void vibrate_freely(const OscillatorGroup& group, const OscillatorInterval& interval) {
    for (double time = 0.0; time < group.periods.maxCoeff(); time += interval.whole.length)
      pass<with_absolute>(group, interval, 0.0, 0.0);
  }

  /// Writes or reads the motion and its largest values.
  void archive(auto& archive) { archive(motion_.value, motion_.rate, pseudo_accelerations_, absolute_accelerations_); }

  /// The largest |w^2 u|, m/s^2.
  [[nodiscard]] const OscillatorNumbers& pseudo_accelerations() const { return pseudo_accelerations_; }
  /// The largest |u'' + a|, m/s^2.
  [[nodiscard]] const OscillatorNumbers& absolute_accelerations() const { return absolute_accelerations_; }

 private:
  using State = OscillatorState<OscillatorNumbers>;

  // Whether a peak may lie inside: a free vibration never exceeds its amplitude, nor with its damping force 1 + 2
  // damping_ratio times that.
  template <bool with_absolute>
  [[nodiscard]] bool may_rise(const OscillatorGroup& group, const State& free, const OscillatorNumbers& forced_0,
                              const OscillatorNumbers& forced_1, double support_0, double support_1) const {
    const OscillatorNumbers quadrature = (free.rate + group.decay * free.value) * group.damped_time;
    const OscillatorNumbers square = free.value.square() + quadrature.square();
    const OscillatorNumbers margin = (pseudo_accelerations_ - forced_0.abs().max(forced_1.abs())).max(0.0);
    if ((square > margin.square()).any()) return true;
    if constexpr (with_absolute) {
      const double support = std::max(std::abs(support_0), std::abs(support_1)), more = 1.0 + 2.0 * group.damping_ratio;
      return (more * more * square > (absolute_accelerations_ - support).max(0.0).square()).any();
    }
    return false;
  }

  template <bool with_absolute>
  void follow_parts(const OscillatorGroup& group, const OscillatorInterval& interval, double support_0, double rate) {
    State at = motion_;
    double before = support_0;
    for (double k = 1.0; k <= interval.parts; ++k) {
      const double now = support_0 - rate * (k * interval.part.length);
      const OscillatorNumbers forced = group.forced(before, rate);
      const State end = interval.part.after({at.value - forced, at.rate - rate}, forced, rate);
      raise_peaks<with_absolute>(group, at, end, before, now, interval.part.length);
      at = end;
      before = now;
    }
  }

  template <bool with_absolute>
  void raise_peaks(const OscillatorGroup& group, const State& start, const State& end, double support_0,
                   double support_1, double step) {
    raise_to_cubics(pseudo_accelerations_, start, end, step);
    if constexpr (with_absolute) {
      const auto absolute = [&](const State& at, double support) {
        const OscillatorNumbers value = -(group.delay * at.rate + at.value);
        return State{value, -(2.0 * group.decay * (value - support) + at.rate)};
      };
      raise_to_cubics(absolute_accelerations_, absolute(start, support_0), absolute(end, support_1), step);
    }
  }

  // Raises peaks to the largest absolute values inside and at the end of a step, of the cubics through values and rates
  // at both ends.
  static void raise_to_cubics(OscillatorNumbers& peaks, const State& start, const State& end, double step) {
    peaks = peaks.max(end.value.abs());
    const OscillatorNumbers reach =
        start.value.abs().max(end.value.abs()) + cubic_beyond_ends * step * (start.rate.abs() + end.rate.abs());
    if ((reach <= peaks).all()) return;
    for (int i = 0; i < oscillators_per_group; ++i) {
      // Steps are short against the period: without a change of sign of the rate there is no extremum inside.
      if (start.rate[i] * end.rate[i] >= 0.0) continue;
      const HermiteCubic cubic{start.value[i], start.rate[i], end.value[i], end.rate[i], step};
      peaks[i] = std::max(peaks[i], std::abs(cubic.value(cubic.turn())));
    }
  }

  State motion_;  // pseudo-acceleration
  OscillatorNumbers pseudo_accelerations_ = OscillatorNumbers::Zero();
  OscillatorNumbers absolute_accelerations_ = OscillatorNumbers::Zero();
};

}  // namespace moat
