// Ordinary differential equations inside a law.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace moat {

/// y(end) of y' = rate(y) from y(0) = start, end >= 0: Dormand and Prince's method of order five (1980) in steps of at
/// most `longest`, with an error of each step below `tolerance` (1 + |y|). Pure, without memory of its own.
template <std::size_t n, class Rate>
std::array<double, n> integrate(const Rate& rate, std::array<double, n> y, double end, double longest,
                                double tolerance) {
  using Values = std::array<double, n>;
  constexpr std::size_t stages = 7;
  constexpr double a[stages][6] = {{},
                                   {1.0 / 5.0},
                                   {3.0 / 40.0, 9.0 / 40.0},
                                   {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
                                   {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
                                   {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
                                   {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}};
  constexpr std::array<double, stages> error_weights{71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                                     -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
  constexpr int most_steps = 100000;
  double at = 0.0, h = std::min(longest, end);
  for (int step = 0; at < end && step < most_steps; ++step) {
    h = std::min(h, end - at);
    std::array<Values, stages> slopes{};
    Values next = y;
    for (std::size_t s = 0; s < stages; ++s) {
      next = y;
      for (std::size_t j = 0; j < s; ++j)
        for (std::size_t i = 0; i < n; ++i) next[i] += h * a[s][j] * slopes[j][i];
      slopes[s] = rate(next);
    }
    double error = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0.0;
      for (std::size_t s = 0; s < stages; ++s) sum += error_weights[s] * slopes[s][i];
      error = std::max(error, std::abs(h * sum) / (tolerance * (1.0 + std::abs(y[i]))));
    }
    const double shortest = 1e-12 * end;
    if (error <= 1.0 || h <= shortest) {
      y = next;
      at = at + h >= end * (1.0 - 1e-15) ? end : at + h;
    }
    h = std::min(longest, h * std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 4.0));
  }
  return y;
}

}  // namespace moat
