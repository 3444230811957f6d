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
/// gamma = 1/2, the only value allowed here: others damp or grow artificially. Second-order accurate, or of fourth
/// order with beta = 1/12 and `corrects_velocity`.
///
/// With beta = 1/12 (Fox and Goodwin) the period of an undamped vibration is right to fourth order, but the method's
/// velocity is not that of the motion: v' = v + h^2/12 j, with j the rate of acceleration (the jerk). It is an error
/// of second order wherever a step begins with another velocity or another length: at the start, after an impact,
/// when the step adapts itself. With corrects_velocity the method goes on with v' inside the step and gives back the
/// velocity of the motion at its end:
///
///     v'0 = v0 + h^2/12 j0        v1 = v'1 - h^2/12 j1        v'1 = v'0 + h/2 (a0 + a1)
///
/// Forces that depend on velocity are evaluated with v1 = v'0 + h^2/12 j0 + h (2/3 a0 + 1/3 a1), where j1 is
/// extrapolated from a0, j0 and a1, j1 = 2 (a1 - a0)/h - j0. All of it is of fourth order, over steps of any lengths.
/// Source: the correction is the end correction of the trapezoidal rule (Euler and Maclaurin) for v.
struct NewmarkScheme {
  /// 0 < beta <= 1/2. Unconditionally stable from 1/4 up.
  double beta = 0.25;
  /// Whether jerks correct the velocity; for beta = 1/12.
  bool corrects_velocity = false;

  static constexpr double gamma = 0.5;

  /// beta = 1/4: unconditionally stable, conserves the energy of linear systems.
  static constexpr NewmarkScheme average_acceleration() { return {.beta = 0.25}; }
  /// beta = 1/6: smaller period error, stable for h <= 0.55 of the shortest period.
  static constexpr NewmarkScheme linear_acceleration() { return {.beta = 1.0 / 6.0}; }
  /// beta = 1/12 with corrected velocities: fourth order, stable for h <= 0.39 of the shortest period without damping
  /// (h w <= 2.45). Adapted steps take it up to h w = 1.8 and h c/m = 4, which is stable with damping too.
  static constexpr NewmarkScheme fourth_order() { return {.beta = 1.0 / 12.0, .corrects_velocity = true}; }

  [[nodiscard]] constexpr int order() const { return corrects_velocity ? 4 : 2; }

  /// Largest stable h * angular frequency of an undamped vibration: 2 / sqrt(1 - 4 beta), infinite from beta = 1/4 on.
  [[nodiscard]] double stability_limit() const {
    return beta >= 0.25 ? std::numeric_limits<double>::infinity() : 2.0 / std::sqrt(1.0 - 4.0 * beta);
  }

  /// The scheme as weights of the last unknown: the acceleration at the end of the step.
  [[nodiscard]] constexpr double displacement_weight(double h) const { return beta * h * h; }
  [[nodiscard]] constexpr double velocity_weight(double h) const { return corrects_velocity ? h / 3.0 : gamma * h; }

  friend bool operator==(const NewmarkScheme&, const NewmarkScheme&) = default;
};

}  // namespace moat
