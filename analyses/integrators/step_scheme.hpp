// One implicit time step as numbers.
#pragma once

#include <cmath>
#include <limits>

namespace moat {

/// The methods of Newmark, Hilber, Hughes & Taylor, and Chung & Hulbert over a step h, from 0 to 1:
///
///     u1 = u0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1)
///     v1 = v0 + h ((1 - gamma) a0 + gamma a1)
///     mass_share M a1 + (1 - mass_share) M a0 + force_share p1 + (1 - force_share) p0 = 0,   p = f(u, v) + M iota a_g
///
/// The unknown is a1; where the equation is averaged, the acceleration of the state at 1 follows from p1. An integrator
/// (analyses/integrators/integrators.hpp) is a choice of these numbers.
///
/// With corrects_velocity, which beta = 1/12 needs (analyses/integrators/newmark.hpp), the step uses v' = v + h^2/12 j,
/// where j is the rate of acceleration (the jerk), and returns the velocity of the motion at its end:
///
///     v'0 = v0 + h^2/12 j0        v'1 = v'0 + h/2 (a0 + a1)        v1 = v'1 - h^2/12 j1
///
/// Forces that depend on velocity are evaluated with v1 = v'0 + h^2/12 j0 + h (2/3 a0 + 1/3 a1), where j1 is
/// extrapolated from a0, j0 and a1, j1 = 2 (a1 - a0)/h - j0. All of it is of fourth order, over steps of any lengths.
///
/// Where dashpots are strong, h c/m > 4, this is not stable. With filters_corrections forces are evaluated with v1 = v0
/// + h/2 (a0 + a1), and every correction h^2/12 j is multiplied by (T^-1 M)^2, where T = M + h/2 C + h^2/12 K is the
/// tangent of the step. This factor is 1 for a slow motion and 0 for one that a strong dashpot holds, whose jerk is
/// round-off of its acceleration times c/m. Third order; stable for dashpots of any strength and h w <= 1.8.
struct StepScheme {
  double beta = 0.25;                ///< 0 <= beta, of the displacement
  double gamma = 0.5;                ///< 0 <= gamma, of the velocity
  double mass_share = 1.0;           ///< of the inertia at the end of the step
  double force_share = 1.0;          ///< of forces and loads at the end of the step
  bool corrects_velocity = false;    ///< needs beta = 1/12
  bool filters_corrections = false;  ///< and jerks, also where velocities are not corrected

  /// Beta = 1/4, gamma = 1/2: second order, stable for steps of any length.
  static constexpr StepScheme average_acceleration() { return {}; }
  /// Beta = 1/12 with corrected velocities.
  static constexpr StepScheme fourth_order() { return {.beta = 1.0 / 12.0, .corrects_velocity = true}; }

  /// The fourth-order scheme with filtered corrections: stable for dashpots of any strength, and of third order.
  static constexpr StepScheme strongly_damped() {
    return {.beta = 1.0 / 12.0, .corrects_velocity = true, .filters_corrections = true};
  }

  /// Returns the order of the error of displacements in the length of the step.
  [[nodiscard]] constexpr int order() const { return !corrects_velocity ? 2 : filters_corrections ? 3 : 4; }
  /// Whether the equation is that of the end of the step alone.
  [[nodiscard]] constexpr bool balances_at_end() const { return mass_share == 1.0 && force_share == 1.0; }

  /// Largest stable h * angular frequency of an undamped vibration: 2 / sqrt(1 - 4 beta), infinite from beta = 1/4 on.
  [[nodiscard]] double stability_limit() const {
    return beta >= 0.25 ? std::numeric_limits<double>::infinity() : 2.0 / std::sqrt(1.0 - 4.0 * beta);
  }

  /// The derivative of the displacement at the end of a step of h s by the acceleration there, s^2.
  [[nodiscard]] constexpr double displacement_weight(double h) const { return beta * h * h; }
  /// The derivative of the velocity at the end of a step by the acceleration there, s.
  [[nodiscard]] constexpr double velocity_weight(double h) const { return order() == 4 ? h / 3.0 : gamma * h; }

  friend bool operator==(const StepScheme&, const StepScheme&) = default;
};

}  // namespace moat
