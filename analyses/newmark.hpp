// The Newmark-beta family of time integrators.
#pragma once

#include <cmath>
#include <limits>

namespace moat {

/// Newmark's method over a step h:
///
///     u1 = u0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1)
///     v1 = v0 + h ((1 - gamma) a0 + gamma a1)
///
/// Second-order accurate for gamma = 1/2, the only value allowed here: others damp or grow artificially.
struct NewmarkScheme {
  /// 0 < beta <= 1/2. Unconditionally stable from 1/4 up.
  double beta = 0.25;

  static constexpr double gamma = 0.5;

  /// beta = 1/4: unconditionally stable, conserves the energy of linear systems.
  static constexpr NewmarkScheme average_acceleration() { return {.beta = 0.25}; }
  /// beta = 1/6: smaller period error, stable for h <= 0.55 of the shortest period.
  static constexpr NewmarkScheme linear_acceleration() { return {.beta = 1.0 / 6.0}; }

  /// Largest stable h * angular frequency of an undamped vibration: 2 / sqrt(1 - 4 beta), infinite from beta = 1/4 on.
  [[nodiscard]] double stability_limit() const {
    return beta >= 0.25 ? std::numeric_limits<double>::infinity() : 2.0 / std::sqrt(1.0 - 4.0 * beta);
  }

  /// The scheme as weights of the last unknown: the acceleration at the end of the step.
  [[nodiscard]] constexpr double displacement_weight(double h) const { return beta * h * h; }
  [[nodiscard]] static constexpr double velocity_weight(double h) { return gamma * h; }
};

}  // namespace moat
