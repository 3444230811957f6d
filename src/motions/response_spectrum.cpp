#include "motions/response_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/hermite.hpp"

namespace moat {
namespace {

// Peaks between steps come from a cubic, which errs by (2 pi / 32)^4 / 384 = 4e-6 of the vibration.
constexpr double steps_per_period = 32.0;
constexpr double shortest_period_in_time_steps = 0.01;
constexpr double longest_period = 1000.0;  // s

// Oscillators in one group: a processor computes several numbers at once.
constexpr int lanes = 4;
using Numbers = Eigen::Array<double, lanes, 1>;

/// Quantities with their rates.
struct Moving {
  Numbers value = Numbers::Zero(), rate = Numbers::Zero();
};

/// Raises peaks to the largest absolute values inside and at the end of a step, of the cubics through values and rates
/// at both ends.
void raise_to_cubics(Numbers& peaks, const Moving& start, const Moving& end, double step) {
  peaks = peaks.max(end.value.abs());
  const Numbers reach =
      start.value.abs().max(end.value.abs()) + cubic_beyond_ends * step * (start.rate.abs() + end.rate.abs());
  if ((reach <= peaks).all()) return;
  for (int i = 0; i < lanes; ++i) {
    // Steps are short against the period: without a change of sign of the rate there is no extremum inside.
    if (start.rate[i] * end.rate[i] >= 0.0) continue;
    const HermiteCubic cubic{start.value[i], start.rate[i], end.value[i], end.rate[i], step};
    peaks[i] = std::max(peaks[i], std::abs(cubic.value(cubic.turn())));
  }
}

/// How many steps an oscillator takes in an interval of the samples.
double substeps_of(double period, double sample_interval) {
  return std::max(1.0, std::ceil(steps_per_period * sample_interval / period));
}

/// Oscillators under a ground acceleration that is linear between samples. They take equally many steps. The numbers of
/// one do not depend on the others.
class Oscillators {
 public:
  Oscillators(const Numbers& periods, double damping_ratio, double sample_interval)
      : periods_{periods}, substeps_{substeps_of(periods[0], sample_interval)}, step_{sample_interval / substeps_} {
    const Numbers circular_frequency = 2.0 * std::numbers::pi / periods;
    stiffness_ = circular_frequency.square();
    damping_ = 2.0 * damping_ratio * circular_frequency;
    flexibility_ = 1.0 / stiffness_;
    rate_of_load_ = flexibility_ / step_;
    const Numbers decay = damping_ratio * circular_frequency;
    const Numbers damped = circular_frequency * std::sqrt(1.0 - damping_ratio * damping_ratio);
    const Numbers fading = (-decay * step_).exp();
    const Numbers cosine = fading * (damped * step_).cos();
    const Numbers sine = fading * (damped * step_).sin() / damped;
    displacement_from_displacement_ = cosine + decay * sine;
    displacement_from_velocity_ = sine;
    velocity_from_displacement_ = -stiffness_ * sine;
    velocity_from_velocity_ = cosine - decay * sine;
  }

  /// Moves on by one interval of the samples.
  void pass_interval(double ground_0, double ground_1) {
    double before = ground_0;
    for (double k = 1.0; k <= substeps_; ++k) {
      const double now = ground_0 + (ground_1 - ground_0) * (k / substeps_);
      advance(before, now);
      before = now;
    }
  }
  /// Free vibration after the end of the motion. The largest values of each oscillator come within its period; later
  /// ones do not count.
  void vibrate_freely() {
    for (double time = 0.0; time < periods_.maxCoeff(); time += step_) {
      const Numbers displacements = peak_displacements_, accelerations = peak_accelerations_;
      advance(0.0, 0.0);
      const auto is_over = periods_ <= time;
      peak_displacements_ = is_over.select(displacements, peak_displacements_);
      peak_accelerations_ = is_over.select(accelerations, peak_accelerations_);
    }
  }

  [[nodiscard]] const Numbers& peak_displacements() const { return peak_displacements_; }
  [[nodiscard]] Numbers peak_pseudo_accelerations() const { return stiffness_ * peak_displacements_; }
  [[nodiscard]] const Numbers& peak_accelerations() const { return peak_accelerations_; }

 private:
  // Moves on by one step and notes the peaks on the way.
  void advance(double ground_0, double ground_1) {
    // The particular solution shift + rate * t follows the linear load; the rest vibrates freely.
    const Numbers rate = (ground_0 - ground_1) * rate_of_load_;
    const Numbers shift = -(ground_0 + damping_ * rate) * flexibility_;
    const Numbers free_displacement = motion_.value - shift;
    const Numbers free_velocity = motion_.rate - rate;
    const Moving motion{
        displacement_from_displacement_ * free_displacement + displacement_from_velocity_ * free_velocity + shift +
            rate * step_,
        velocity_from_displacement_ * free_displacement + velocity_from_velocity_ * free_velocity + rate};
    // The ground may have jumped since the last step, and the rate of acceleration with it.
    acceleration_.rate = jerk(acceleration_.value, motion_.rate, ground_0);
    Moving acceleration{-damping_ * motion.rate - stiffness_ * motion.value, Numbers{}};
    acceleration.rate = jerk(acceleration.value, motion.rate, ground_1);

    raise_to_cubics(peak_displacements_, motion_, motion, step_);
    raise_to_cubics(peak_accelerations_, acceleration_, acceleration, step_);
    motion_ = motion;
    acceleration_ = acceleration;
  }

  // Rates of the absolute accelerations.
  [[nodiscard]] Numbers jerk(const Numbers& absolute_acceleration, const Numbers& velocity, double ground) const {
    return -damping_ * (absolute_acceleration - ground) - stiffness_ * velocity;
  }

  Numbers periods_;
  double substeps_;  // of an interval of the samples
  double step_;
  Numbers stiffness_, damping_;  // per mass
  Numbers flexibility_;          // 1 / stiffness
  Numbers rate_of_load_;         // 1 / (stiffness step)
  Numbers displacement_from_displacement_, displacement_from_velocity_;
  Numbers velocity_from_displacement_, velocity_from_velocity_;
  Moving motion_;        // displacement and velocity
  Moving acceleration_;  // absolute
  Numbers peak_displacements_ = Numbers::Zero(), peak_accelerations_ = Numbers::Zero();
};

}  // namespace

ResponseSpectrum response_spectrum(const GroundMotion& motion, std::span<const Time> periods, double damping_ratio) {
  const Check check{"response_spectrum", motion.name()};
  check.that(damping_ratio >= 0.0 && damping_ratio < 1.0, "damping_ratio", damping_ratio, "1", ">= 0 and < 1",
             "Give 5 % as 0.05.");
  check.that(!motion.has_two_components(), "the motion has two components.",
             "Take the spectrum of one of them, or maximum_direction_spectrum() of the pair.");
  const double shortest = shortest_period_in_time_steps * motion.time_step();
  const double peak_of_ground = motion.peak_acceleration().si();
  ResponseSpectrum spectrum;
  spectrum.damping_ratio = damping_ratio;
  std::vector<std::size_t> moving;
  for (const Time quantity : periods) {
    const double period = quantity.si();
    check.that(period == 0.0 || (period >= shortest && period <= longest_period), "period", period, "s",
               "0 s, or from " + to_text(shortest) + " s to " + to_text(longest_period) + " s",
               "Give 0 s for a rigid oscillator.");
    if (period > 0.0) moving.push_back(spectrum.period.size());
    spectrum.period.push_back(period);
    spectrum.displacement.push_back(0.0);
    spectrum.pseudo_acceleration.push_back(peak_of_ground);
    spectrum.absolute_acceleration.push_back(peak_of_ground);
  }
  const std::span<const double> samples = motion.samples();
  for (std::size_t first = 0, size = 0; first < moving.size(); first += size) {
    const auto substeps = [&](std::size_t i) { return substeps_of(spectrum.period[moving[i]], motion.time_step()); };
    for (size = 1; size < lanes && first + size < moving.size() && substeps(first + size) == substeps(first);) ++size;
    // A group with fewer oscillators repeats its last one.
    const auto entry = [&](int lane) { return moving[first + std::min(static_cast<std::size_t>(lane), size - 1)]; };
    Numbers of_group;
    for (int i = 0; i < lanes; ++i) of_group[i] = spectrum.period[entry(i)];
    Oscillators oscillators{of_group, damping_ratio, motion.time_step()};
    for (std::size_t i = 1; i < samples.size(); ++i) oscillators.pass_interval(samples[i - 1], samples[i]);
    oscillators.vibrate_freely();
    for (int i = 0; i < lanes; ++i) {
      spectrum.displacement[entry(i)] = oscillators.peak_displacements()[i];
      spectrum.pseudo_acceleration[entry(i)] = oscillators.peak_pseudo_accelerations()[i];
      spectrum.absolute_acceleration[entry(i)] = oscillators.peak_accelerations()[i];
    }
  }
  return spectrum;
}

}  // namespace moat
