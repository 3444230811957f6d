#include "motions/response_spectrum.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "motions/oscillators.hpp"

namespace moat {
namespace {

constexpr double shortest_period_in_time_steps = 0.01;
constexpr double longest_period = 1000.0;  // s

}  // namespace

void check_damping_ratio(const Check& check, double damping_ratio) {
  check.that(damping_ratio >= 0.0 && damping_ratio < 1.0, "damping_ratio", damping_ratio, "1", ">= 0 and < 1",
             "Give 5 % as 0.05.");
}

void check_oscillators(const Check& check, std::span<const Time> periods, double damping_ratio, double time_step) {
  check_damping_ratio(check, damping_ratio);
  const double shortest = shortest_period_in_time_steps * time_step;
  for (const Time period : periods)
    check.that(period.si() == 0.0 || (period.si() >= shortest && period.si() <= longest_period), "period", period.si(),
               "s", "0 s, or from " + to_text(shortest) + " s to " + to_text(longest_period) + " s",
               "Give 0 s for a rigid oscillator.");
}

ResponseSpectrum response_spectrum(const GroundMotion& motion, std::span<const Time> periods, double damping_ratio) {
  const Check check{"response_spectrum", motion.name()};
  check.that(!motion.has_two_components(), "the motion has two components.",
             "Take the spectrum of one of them, or pair_spectra() of the pair.");
  check_oscillators(check, periods, damping_ratio, motion.time_step());
  const double peak_of_ground = motion.peak_acceleration().si();
  ResponseSpectrum spectrum;
  spectrum.damping_ratio = damping_ratio;
  std::vector<std::size_t> moving;
  for (const Time quantity : periods) {
    const double period = quantity.si();
    if (period > 0.0) moving.push_back(spectrum.period.size());
    spectrum.period.push_back(period);
    spectrum.displacement.push_back(0.0);
    spectrum.pseudo_acceleration.push_back(peak_of_ground);
    spectrum.absolute_acceleration.push_back(peak_of_ground);
  }
  const std::span<const double> samples = motion.samples();
  for (std::size_t first = 0, size = 0; first < moving.size(); first += size) {
    const auto steps = [&](std::size_t i) { return oscillator_steps(spectrum.period[moving[i]], motion.time_step()); };
    for (size = 1; size < oscillators_per_group && first + size < moving.size() && steps(first + size) == steps(first);)
      ++size;
    // A group with fewer oscillators repeats its last one.
    const auto entry = [&](int lane) { return moving[first + std::min(static_cast<std::size_t>(lane), size - 1)]; };
    OscillatorNumbers of_group;
    for (int i = 0; i < oscillators_per_group; ++i) of_group[i] = spectrum.period[entry(i)];
    const OscillatorGroup group{of_group, damping_ratio};
    const OscillatorInterval interval{group, motion.time_step()};
    OscillatorMotion oscillators;
    for (std::size_t i = 1; i < samples.size(); ++i)
      oscillators.pass<true>(group, interval, samples[i - 1], samples[i]);
    oscillators.vibrate_freely<true>(group, interval);
    for (int i = 0; i < oscillators_per_group; ++i) {
      const double pseudo = oscillators.pseudo_accelerations()[i], frequency = group.frequency[i];
      spectrum.displacement[entry(i)] = pseudo / (frequency * frequency);
      spectrum.pseudo_acceleration[entry(i)] = pseudo;
      spectrum.absolute_acceleration[entry(i)] = oscillators.absolute_accelerations()[i];
    }
  }
  return spectrum;
}

}  // namespace moat
