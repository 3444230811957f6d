#include "random_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moat::testing {
namespace {

using std::numbers::pi;

constexpr double gravity = 9.80665;  // m/s^2

// x'' + 2 z w x' + w^2 x = input, in steps of semi-implicit Euler: a filter, not a solution.
struct Filter {
  double frequency, damping;
  double x = 0.0, v = 0.0, a = 0.0;

  void feed(double input, double dt) {
    a = input - 2.0 * damping * frequency * v - frequency * frequency * x;
    v += dt * a;
    x += dt * v;
  }
};

std::vector<double> noise(RandomDraws& draws, double dt, std::size_t count) {
  Filter soil{2.0 * pi * draws.uniform(1.0, 4.0), draws.uniform(0.3, 0.7)};
  Filter low_cut{2.0 * pi * draws.uniform(0.1, 0.3), 0.7};
  const double duration = dt * static_cast<double>(count - 1);
  const double rise = draws.uniform(0.1, 0.3) * duration, fall = draws.uniform(0.5, 0.9) * duration;
  std::vector<double> samples(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = dt * static_cast<double>(i);
    const double envelope = t < rise   ? t * t / (rise * rise)
                            : t < fall ? 1.0
                                       : std::exp(-3.0 * (t - fall) / (duration - fall));
    soil.feed(draws.normal(), dt);
    low_cut.feed(soil.frequency * soil.frequency * soil.x, dt);
    samples[i] = envelope * low_cut.a;
  }
  return samples;
}

// The acceleration of the velocity pulse cos(2 pi f (t - t0)) (1 + cos(2 pi f (t - t0)/c))/2 of c cycles.
std::vector<double> pulse(RandomDraws& draws, double dt, std::size_t count) {
  const double duration = dt * static_cast<double>(count - 1);
  const double cycles = draws.uniform(1.5, 3.0);
  const double frequency = std::max(1.0 / draws.uniform(0.6, 3.0), cycles / duration);
  const double middle = 0.5 * cycles / frequency + draws.uniform(0.0, 0.3) * (duration - cycles / frequency);
  const double phase = draws.uniform(0.0, 2.0 * pi), w = 2.0 * pi * frequency;
  std::vector<double> samples(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = dt * static_cast<double>(i) - middle;
    if (std::abs(t) >= 0.5 * cycles / frequency) continue;
    samples[i] = -w * std::sin(w * t + phase) * 0.5 * (1.0 + std::cos(w * t / cycles)) -
                 w / cycles * 0.5 * std::sin(w * t / cycles) * std::cos(w * t + phase);
  }
  return samples;
}

std::vector<double> box(RandomDraws& draws, double dt, std::size_t count) {
  std::vector<double> samples(count, 0.0);
  const auto from = static_cast<std::size_t>(draws.chance(0.5) ? 0.0 : draws.uniform(0.1, 1.0) / dt);
  const auto to = std::min(count, from + static_cast<std::size_t>(draws.uniform(0.2, 1.0) / dt));
  std::fill(samples.begin() + static_cast<long>(from), samples.begin() + static_cast<long>(to), 1.0);
  return samples;
}

}  // namespace

PlainMotion random_motion(RandomDraws& draws) {
  constexpr double intervals[] = {0.005, 0.01, 0.02};
  PlainMotion motion;
  motion.time_step = intervals[draws.integer(0, 2)];
  const double kind = draws.unit();
  const double duration = draws.uniform(4.0, draws.chance(0.3) ? 20.0 : 10.0);
  const auto count = static_cast<std::size_t>(duration / motion.time_step) + 1;
  motion.samples = kind < 0.5    ? noise(draws, motion.time_step, count)
                   : kind < 0.92 ? pulse(draws, motion.time_step, count)
                                 : box(draws, motion.time_step, count);
  if (kind < 0.5 && draws.chance(0.2)) motion.samples.resize(count / 2);
  double largest = 0.0;
  for (const double sample : motion.samples) largest = std::max(largest, std::abs(sample));
  const double peak = draws.uniform(0.1, kind < 0.92 ? 0.8 : 0.3) * gravity;
  // To a micrometre per square second: the same everywhere.
  for (double& sample : motion.samples) sample = std::round(sample / largest * peak * 1e6) / 1e6;
  return motion;
}

}  // namespace moat::testing
