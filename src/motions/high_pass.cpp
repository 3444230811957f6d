#include "motions/high_pass.hpp"

#include <cmath>
#include <numbers>

#include "base/check.hpp"

namespace moat {
namespace {

/// y[i] = b0 x[i] + b1 x[i-1] + b2 x[i-2] - a1 y[i-1] - a2 y[i-2], from rest.
struct Section {
  double b0, b1, b2, a1, a2;

  void run(std::vector<double>& signal) const {
    double first = 0.0, second = 0.0;  // contributions of past samples to this one and to the next
    for (double& value : signal) {
      const double in = value;
      value = b0 * in + first;
      first = b1 * in - a1 * value + second;
      second = b2 * in - a2 * value;
    }
  }
};

/// s/(s + 1) with s = (1 - 1/z)/(1 + 1/z)/k.
Section first_order(double k) {
  const double b = 1.0 / (1.0 + k);
  return {b, -b, 0.0, (k - 1.0) * b, 0.0};
}

/// s^2/(s^2 + damping s + 1) with s = (1 - 1/z)/(1 + 1/z)/k.
Section second_order(double k, double damping) {
  const double b = 1.0 / (1.0 + damping * k + k * k);
  return {b, -2.0 * b, b, 2.0 * (k * k - 1.0) * b, (1.0 - damping * k + k * k) * b};
}

}  // namespace

GroundMotion high_passed(const GroundMotion& motion, Frequency corner, int order) {
  const Check check{"high_passed", motion.name()};
  const double highest = 0.5 / motion.time_step();
  check.that(corner.si() > 0.0 && corner.si() < highest, "corner", corner.si(), "Hz",
             "> 0 Hz and < " + to_text(highest) + " Hz", "A record holds nothing above half its sampling frequency.");
  check.between("order", order, 1, 20, "1");

  const double k = std::tan(std::numbers::pi * corner.si() * motion.time_step());
  std::vector<double> samples{motion.samples().begin(), motion.samples().end()};
  for (int pair = 0; pair < order / 2; ++pair)
    second_order(k, 2.0 * std::sin((2 * pair + 1) * std::numbers::pi / (2 * order))).run(samples);
  if (order % 2 == 1) first_order(k).run(samples);

  return motion.with_samples(std::move(samples), "Causal Butterworth high-pass, order " + std::to_string(order) +
                                                     ", corner " + to_text(corner.si()) + " Hz.");
}

}  // namespace moat
