#include "motions/vertical_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motions/oscillators.hpp"

namespace moat {

VerticalMotion::VerticalMotion(const GroundMotion& motion, Time period, double damping_ratio)
    : ground_{motion.samples_z().begin(), motion.samples_z().end()},
      interval_{motion.time_step()},
      frequency_{2.0 * std::numbers::pi / period.si()},
      damping_ratio_{damping_ratio},
      states_(ground_.size()) {
  for (std::size_t i = 1; i < ground_.size(); ++i)
    states_[i] = later(states_[i - 1], ground_[i - 1], (ground_[i] - ground_[i - 1]) / interval_, interval_);
}

VerticalMotion::State VerticalMotion::later(const State& start, double load, double load_rate, double time) const {
  using Numbers = Eigen::Array<double, 1, 1>;
  const Oscillators<Numbers> mode{Numbers{2.0 * std::numbers::pi / frequency_}, damping_ratio_};
  const Numbers forced = mode.forced(Numbers{load}, Numbers{-load_rate});
  const OscillatorState<Numbers> free{Numbers{start.value} - forced, Numbers{start.rate + load_rate}};
  const OscillatorState<Numbers> end = OscillatorStep<Numbers>{mode, time}.after(free, forced, Numbers{-load_rate});
  return {end.value(0), end.rate(0)};
}

VerticalMotion::Instant VerticalMotion::instant(double time) const {
  if (!(time >= 0.0) || ground_.empty()) return {};
  constexpr double round_off = 1e-8;
  const double position = time / interval_, nearest = std::round(position);
  const double before = std::abs(position - nearest) <= round_off ? nearest : std::floor(position);
  const std::size_t last = ground_.size() - 1, sample = std::min(static_cast<std::size_t>(before), last);
  const double since = time - static_cast<double>(sample) * interval_;
  if (sample == last) return {.mode = later(states_[last], 0.0, 0.0, since)};
  const double rate = (ground_[sample + 1] - ground_[sample]) / interval_;
  return {.mode = later(states_[sample], ground_[sample], rate, since), .ground = ground_[sample] + rate * since};
}

double VerticalMotion::acceleration(const State& mode) const {
  return -(mode.value + 2.0 * damping_ratio_ / frequency_ * mode.rate);
}
double VerticalMotion::acceleration(double time) const { return acceleration(instant(time).mode); }

double VerticalMotion::rate(double time) const {
  const Instant at = instant(time);
  // w'' = a_v - a_gv.
  return -(at.mode.rate + 2.0 * damping_ratio_ * frequency_ * (acceleration(at.mode) - at.ground));
}

double VerticalMotion::longest_step() const {
  constexpr double steps_per_period = 20.0;
  return 2.0 * std::numbers::pi / frequency_ / steps_per_period;
}

}  // namespace moat
