#include "motions/vertical_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moat {

VerticalMotion::VerticalMotion(const GroundMotion& motion, Time period, double damping_ratio)
    : ground_{motion.samples_z().begin(), motion.samples_z().end()},
      interval_{motion.time_step()},
      frequency_{period.si() > 0.0 ? 2.0 * std::numbers::pi / period.si() : 0.0},
      damping_ratio_{damping_ratio} {
  if (frequency_ == 0.0) return;
  states_.resize(ground_.size());
  for (std::size_t i = 1; i < ground_.size(); ++i)
    states_[i] = later(states_[i - 1], ground_[i - 1], (ground_[i] - ground_[i - 1]) / interval_, interval_);
}

// The particular solution shift + slope t follows the linear load; the rest vibrates freely.
VerticalMotion::State VerticalMotion::later(const State& start, double load, double load_rate, double time) const {
  const double slope = -load_rate, shift = -load - 2.0 * damping_ratio_ / frequency_ * slope;
  const double free_value = start.value - shift, free_rate = start.rate - slope;
  const double decay = damping_ratio_ * frequency_,
               damped = frequency_ * std::sqrt(1.0 - damping_ratio_ * damping_ratio_);
  const double fading = std::exp(-decay * time), cosine = fading * std::cos(damped * time),
               sine = fading * std::sin(damped * time) / damped;
  return {shift + slope * time + (cosine + decay * sine) * free_value + sine * free_rate,
          slope + (cosine - decay * sine) * free_rate - frequency_ * frequency_ * sine * free_value};
}

VerticalMotion::Instant VerticalMotion::instant(double time, Side side) const {
  constexpr double round_off = 1e-8;
  const double position = time / interval_, nearest = std::round(position);
  const bool at_sample = std::abs(position - nearest) <= round_off;
  const double first = at_sample ? nearest - (side == Side::before ? 1.0 : 0.0) : std::floor(position);
  if (first < 0.0 || ground_.empty()) return {.before = true};
  const std::size_t last = ground_.size() - 1, sample = std::min(static_cast<std::size_t>(first), last);
  const double since = time - static_cast<double>(sample) * interval_;
  if (sample == last) return {.sample = last, .since = since};
  const double rate = (ground_[sample + 1] - ground_[sample]) / interval_;
  return {.sample = sample, .since = since, .ground = ground_[sample] + rate * since, .ground_rate = rate};
}

VerticalMotion::State VerticalMotion::state(const Instant& at) const {
  return later(states_[at.sample], at.ground - at.ground_rate * at.since, at.ground_rate, at.since);
}

double VerticalMotion::acceleration(double time) const {
  // The side decides at the first and at the last sample, where the ground's acceleration may jump.
  const Instant at = instant(time, time > 0.0 ? Side::before : Side::after);
  if (at.before) return 0.0;
  if (frequency_ == 0.0) return at.ground;
  const State mode = state(at);
  return -(mode.value + 2.0 * damping_ratio_ / frequency_ * mode.rate);
}

double VerticalMotion::rate(double time, Side side) const {
  const Instant at = instant(time, side);
  if (at.before) return 0.0;
  if (frequency_ == 0.0) return at.ground_rate;
  const State mode = state(at);
  // w'' = a_v - a_gv.
  const double relative = -(mode.value + 2.0 * damping_ratio_ / frequency_ * mode.rate) - at.ground;
  return -(mode.rate + 2.0 * damping_ratio_ * frequency_ * relative);
}

double VerticalMotion::longest_step() const {
  constexpr double steps_per_period = 20.0;
  return frequency_ > 0.0 ? 2.0 * std::numbers::pi / frequency_ / steps_per_period
                          : std::numeric_limits<double>::infinity();
}

}  // namespace moat
