// The response of the steel around a lead core, as Kalpakidis & Constantinou (2009) print it.
#pragma once

#include <cmath>
#include <numbers>

namespace moat::testing {

/// F(t+), the integral of the response at the time t+ = alpha_s t/a^2 > 0.
inline double steel_response(double t) {
  constexpr double pi = std::numbers::pi, change = 0.6;
  if (t < change) {
    const double quarter = 0.25 * t;
    return 2.0 * std::sqrt(t / pi) - t / pi * (2.0 - quarter - quarter * quarter - 3.75 * quarter * quarter * quarter);
  }
  const double x = 1.0 / (4.0 * t);
  return 8.0 / (3.0 * pi) - 0.5 / std::sqrt(pi * t) * (1.0 - x / 3.0 + x * x / 6.0 - x * x * x / 12.0);
}

}  // namespace moat::testing
