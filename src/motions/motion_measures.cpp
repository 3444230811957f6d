#include "motions/motion_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/check.hpp"
#include "base/root.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

constexpr double shortest_pulse = 0.1, longest_pulse = 20.0;  // s
constexpr int pulse_periods = 400;
constexpr double pulse_damping = 0.05;

void check_one_component(const char* function, const GroundMotion& motion) {
  Check{function, motion.name()}.that(!motion.has_two_components(), "the motion has two components.",
                                      "Take one of them: PlanMotion::first or second.");
}

/// Integral of the square of a line from a to b, over its first part.
double integral_of_square(double a, double b, double step, double part) {
  const double end = a + part * (b - a);
  return part * step * (a * a + a * end + end * end) / 3.0;
}

/// Integral of the squared acceleration up to every sample.
std::vector<double> integrals_of_square(const GroundMotion& motion) {
  const std::span<const double> samples = motion.samples();
  std::vector<double> sums(samples.size(), 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i)
    sums[i] = sums[i - 1] + integral_of_square(samples[i - 1], samples[i], motion.time_step(), 1.0);
  return sums;
}

double time_of(const GroundMotion& motion, const std::vector<double>& sums, double value) {
  const auto found = std::lower_bound(sums.begin(), sums.end(), value);
  const auto after = static_cast<std::size_t>(found - sums.begin());
  if (after == 0) return 0.0;
  if (found == sums.end()) return motion.duration();
  const double a = motion.samples()[after - 1], b = motion.samples()[after];
  const double part = root_between(
      [&](double x) { return sums[after - 1] + integral_of_square(a, b, motion.time_step(), x) - value; }, 0.0, 1.0);
  return motion.time_step() * (static_cast<double>(after - 1) + part);
}

}  // namespace

Speed arias_intensity(const GroundMotion& motion) {
  check_one_component("arias_intensity", motion);
  return Speed{std::numbers::pi / (2.0 * standard_gravity) * integrals_of_square(motion).back()};
}

MotionInterval significant_duration(const GroundMotion& motion, double from, double to) {
  check_one_component("significant_duration", motion);
  const Check check{"significant_duration", motion.name()};
  check.that(from >= 0.0 && from < 1.0, "from", from, "1", ">= 0 and < 1", "Give 5 % as 0.05.");
  check.that(to > from && to <= 1.0, "to", to, "1", "> from and <= 1", "Give 95 % as 0.95.");
  const std::vector<double> sums = integrals_of_square(motion);
  check.that(sums.back() > 0.0, "the motion is zero everywhere and has no duration.", "Check the file.");
  return {time_of(motion, sums, from * sums.back()), time_of(motion, sums, to * sums.back())};
}

std::vector<Time> spaced_periods(Time first, Time last, int count) {
  const Check check{"spaced_periods", ""};
  check.positive("first", first);
  check.that(last > first && std::isfinite(last.si()), "last", last.si(), "s", "> first and finite");
  check.that(count >= 2, "count", count, "1", ">= 2");
  std::vector<Time> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  periods.back() = last;
  return periods;
}

std::vector<double> pseudo_velocity(const ResponseSpectrum& spectrum) {
  std::vector<double> values;
  for (std::size_t i = 0; i < spectrum.period.size(); ++i)
    values.push_back(spectrum.period[i] / (2.0 * std::numbers::pi) * spectrum.pseudo_acceleration[i]);
  return values;
}

Time pulse_period(const GroundMotion& motion) {
  check_one_component("pulse_period", motion);
  // A coarse motion has no shorter periods.
  const double first = std::max(shortest_pulse, motion.time_step());
  const ResponseSpectrum spectrum = response_spectrum(
      motion, spaced_periods(Time{first}, Time{std::max(longest_pulse, 2.0 * first)}, pulse_periods), pulse_damping);
  const std::vector<double> velocities = pseudo_velocity(spectrum);
  return Time{spectrum.period[static_cast<std::size_t>(std::ranges::max_element(velocities) - velocities.begin())]};
}

}  // namespace moat
