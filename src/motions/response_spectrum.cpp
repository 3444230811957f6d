#include "motions/response_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "base/check.hpp"
#include "base/hermite.hpp"

namespace moat {
namespace {

// Peaks between steps come from a cubic, which errs by (2 pi / 32)^4 / 384 = 4e-6 of the vibration.
constexpr double steps_per_period = 32.0;
constexpr double shortest_period_in_time_steps = 0.01;
constexpr double longest_period = 1000.0;  // s

/// A quantity with its rate.
struct Moving {
  double value = 0.0, rate = 0.0;
};

/// The largest absolute value inside and at the end of a step, of the cubic through values and rates at both ends.
double peak_of_cubic(Moving start, Moving end, double step) {
  const double peak = std::abs(end.value);
  // Steps are short against the period: without a change of sign of the rate there is no extremum inside.
  if (start.rate * end.rate >= 0.0) return peak;
  const HermiteCubic cubic{start.value, start.rate, end.value, end.rate, step};
  return std::max(peak, std::abs(cubic.value(cubic.turn())));
}

/// One oscillator under a ground acceleration that is linear over a step of constant length.
class Oscillator {
 public:
  Oscillator(double circular_frequency, double damping_ratio, double step)
      : stiffness_{circular_frequency * circular_frequency},
        damping_{2.0 * damping_ratio * circular_frequency},
        step_{step},
        flexibility_{1.0 / stiffness_},
        rate_of_load_{flexibility_ / step} {
    const double decay = damping_ratio * circular_frequency;
    const double damped = circular_frequency * std::sqrt(1.0 - damping_ratio * damping_ratio);
    const double fading = std::exp(-decay * step);
    const double cosine = fading * std::cos(damped * step);
    const double sine = fading * std::sin(damped * step) / damped;
    displacement_from_displacement_ = cosine + decay * sine;
    displacement_from_velocity_ = sine;
    velocity_from_displacement_ = -stiffness_ * sine;
    velocity_from_velocity_ = cosine - decay * sine;
  }

  /// Moves on by one step and notes the peaks on the way.
  void advance(double ground_0, double ground_1) {
    // The particular solution shift + rate * t follows the linear load; the rest vibrates freely.
    const double rate = (ground_0 - ground_1) * rate_of_load_;
    const double shift = -(ground_0 + damping_ * rate) * flexibility_;
    const double free_displacement = motion_.value - shift;
    const double free_velocity = motion_.rate - rate;
    const Moving motion{
        displacement_from_displacement_ * free_displacement + displacement_from_velocity_ * free_velocity + shift +
            rate * step_,
        velocity_from_displacement_ * free_displacement + velocity_from_velocity_ * free_velocity + rate};
    // The load may have jumped since the last step, and the rate of acceleration with it.
    acceleration_.rate = jerk(acceleration_.value, motion_.rate, ground_0);
    Moving acceleration{-damping_ * motion.rate - stiffness_ * motion.value, 0.0};
    acceleration.rate = jerk(acceleration.value, motion.rate, ground_1);

    peak_displacement_ = std::max(peak_displacement_, peak_of_cubic(motion_, motion, step_));
    peak_acceleration_ = std::max(peak_acceleration_, peak_of_cubic(acceleration_, acceleration, step_));
    motion_ = motion;
    acceleration_ = acceleration;
  }

  [[nodiscard]] double peak_displacement() const { return peak_displacement_; }
  [[nodiscard]] double peak_acceleration() const { return peak_acceleration_; }

 private:
  /// Rate of the absolute acceleration.
  [[nodiscard]] double jerk(double absolute_acceleration, double velocity, double ground) const {
    return -damping_ * (absolute_acceleration - ground) - stiffness_ * velocity;
  }

  double stiffness_;  // per mass
  double damping_;    // per mass
  double step_;
  double flexibility_;   // 1 / stiffness
  double rate_of_load_;  // 1 / (stiffness step)
  double displacement_from_displacement_, displacement_from_velocity_;
  double velocity_from_displacement_, velocity_from_velocity_;
  Moving motion_;        // displacement and velocity
  Moving acceleration_;  // absolute
  double peak_displacement_ = 0.0;
  double peak_acceleration_ = 0.0;
};

Oscillator shaken(const GroundMotion& motion, double period, double damping_ratio) {
  const std::span<const double> samples = motion.samples();
  const double substeps = std::max(1.0, std::ceil(steps_per_period * motion.time_step() / period));
  const double step = motion.time_step() / substeps;
  Oscillator oscillator{2.0 * std::numbers::pi / period, damping_ratio, step};
  for (std::size_t i = 1; i < samples.size(); ++i) {
    double ground_0 = samples[i - 1];
    for (double k = 1.0; k <= substeps; ++k) {
      const double ground_1 = samples[i - 1] + (samples[i] - samples[i - 1]) * (k / substeps);
      oscillator.advance(ground_0, ground_1);
      ground_0 = ground_1;
    }
  }
  // The largest free vibration comes within one period.
  for (double time = 0.0; time < period; time += step) oscillator.advance(0.0, 0.0);
  return oscillator;
}

}  // namespace

ResponseSpectrum response_spectrum(const GroundMotion& motion, std::span<const Time> periods, double damping_ratio) {
  const Check check{"response_spectrum", motion.name()};
  check.that(damping_ratio >= 0.0 && damping_ratio < 1.0, "damping_ratio", damping_ratio, "1", ">= 0 and < 1",
             "Give 5 % as 0.05.");
  check.that(!motion.has_two_components(), "the motion has two components.",
             "Take the spectrum of one of them, or maximum_direction_spectrum() of the pair.");
  const double shortest = shortest_period_in_time_steps * motion.time_step();
  ResponseSpectrum spectrum;
  spectrum.damping_ratio = damping_ratio;
  for (const Time period_quantity : periods) {
    const double period = period_quantity.si();
    check.that(period == 0.0 || (period >= shortest && period <= longest_period), "period", period, "s",
               "0 s, or from " + to_text(shortest) + " s to " + to_text(longest_period) + " s",
               "Give 0 s for a rigid oscillator.");
    spectrum.period.push_back(period);
    if (period == 0.0) {
      spectrum.displacement.push_back(0.0);
      spectrum.pseudo_acceleration.push_back(motion.peak_acceleration().si());
      spectrum.absolute_acceleration.push_back(motion.peak_acceleration().si());
      continue;
    }
    const double circular_frequency = 2.0 * std::numbers::pi / period;
    const Oscillator oscillator = shaken(motion, period, damping_ratio);
    spectrum.displacement.push_back(oscillator.peak_displacement());
    spectrum.pseudo_acceleration.push_back(circular_frequency * circular_frequency * oscillator.peak_displacement());
    spectrum.absolute_acceleration.push_back(oscillator.peak_acceleration());
  }
  return spectrum;
}

}  // namespace moat
