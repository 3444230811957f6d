#include "motions/scaling.hpp"

#include <cmath>

#include "base/check.hpp"
#include "motions/motion_measures.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

// Periods in the average of spectral accelerations: their number, and the ends of their range over the period given.
constexpr int number_of_periods = 10;
constexpr double shortest_share = 0.2, longest_share = 3.0;

template <class Q>
double factor(const std::string& name, const char* measure, Q now, Q target) {
  const Check check{"GroundMotion", name};
  check.positive(std::string{"target "} + measure, target);
  check.that(now.si() > 0.0, std::string{"its "} + measure + " is zero.", "A motion without motion cannot be scaled.");
  return target.si() / now.si();
}

template <class Q, class Measure>
PlanMotion scaled_pair(const PlanMotion& pair, const char* name, Q target, const Measure& measure) {
  const Q now{std::sqrt(measure(pair.first).si() * measure(pair.second).si())};
  const double by = factor(pair.first.name() + " and " + pair.second.name(), name, now, target);
  return pair.scaled_by(by);
}

}  // namespace

Acceleration spectral_acceleration(const GroundMotion& motion, Time period, double damping_ratio) {
  return Acceleration{response_spectrum(motion, {period}, damping_ratio).pseudo_acceleration.front()};
}

std::vector<Time> periods_around(Time period) {
  Check{"periods_around", ""}.positive("period", period);
  return spaced_periods(shortest_share * period, longest_share * period, number_of_periods);
}

Acceleration average_spectral_acceleration(const GroundMotion& motion, std::span<const Time> periods,
                                           double damping_ratio) {
  Check{"average_spectral_acceleration", motion.name()}.that(!periods.empty(), "there are no periods.",
                                                             "Give at least one.");
  double sum = 0.0;
  for (const double each : response_spectrum(motion, periods, damping_ratio).pseudo_acceleration) sum += std::log(each);
  return Acceleration{std::exp(sum / static_cast<double>(periods.size()))};
}

GroundMotion scaled_to_pgv(const GroundMotion& motion, Speed target) {
  return motion.scaled_by(factor(motion.name(), "PGV", motion.peak_velocity(), target));
}

GroundMotion scaled_to_sa(const GroundMotion& motion, Time period, Acceleration target, double damping_ratio) {
  const Acceleration now = spectral_acceleration(motion, period, damping_ratio);
  return motion.scaled_by(factor(motion.name(), "spectral acceleration", now, target));
}

GroundMotion scaled_to_average_sa(const GroundMotion& motion, std::span<const Time> periods, Acceleration target,
                                  double damping_ratio) {
  const Acceleration now = average_spectral_acceleration(motion, periods, damping_ratio);
  return motion.scaled_by(factor(motion.name(), "average spectral acceleration", now, target));
}

PlanMotion scaled_to_pga(const PlanMotion& pair, Acceleration target) {
  return scaled_pair(pair, "PGA", target, [](const GroundMotion& each) { return each.peak_acceleration(); });
}

PlanMotion scaled_to_pgv(const PlanMotion& pair, Speed target) {
  return scaled_pair(pair, "PGV", target, [](const GroundMotion& each) { return each.peak_velocity(); });
}

PlanMotion scaled_to_sa(const PlanMotion& pair, Time period, Acceleration target, double damping_ratio) {
  return scaled_pair(pair, "spectral acceleration", target,
                     [&](const GroundMotion& each) { return spectral_acceleration(each, period, damping_ratio); });
}

PlanMotion scaled_to_average_sa(const PlanMotion& pair, std::span<const Time> periods, Acceleration target,
                                double damping_ratio) {
  return scaled_pair(pair, "average spectral acceleration", target, [&](const GroundMotion& each) {
    return average_spectral_acceleration(each, periods, damping_ratio);
  });
}

}  // namespace moat
