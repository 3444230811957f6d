// Newmark's method.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analyses/integrators/step_scheme.hpp"
#include "base/check.hpp"

namespace moat {

/// Newmark's method (Newmark 1959) with gamma = 1/2, which has no numerical damping. Other values of gamma damp or
/// amplify the motion. Second-order accurate, or of fourth order with beta = 1/12 and corrects_velocity.
///
/// With beta = 1/12 (Fox and Goodwin) the period of an undamped vibration has an error of fourth order, but the
/// velocity of the method is v' = v + h^2/12 j, with j the rate of acceleration. To use v in its place is an error of
/// second order where a step begins with another velocity or another length: at the start, after an impact, where the
/// step length changes. corrects_velocity removes this error (analyses/integrators/step_scheme.hpp). Source: the
/// correction is the end correction of the trapezoidal rule (Euler and Maclaurin) for v.
struct Newmark {
  static constexpr std::string_view name = "newmark";

  /// > 0, <= 1/2. Unconditionally stable from 1/4 up. None: fourth order in an adaptive step that is inside its bound
  /// of stability, average acceleration elsewhere, in the first step after a touch, and in a fixed step.
  std::optional<double> beta{};
  /// Whether jerks correct the velocity; for beta = 1/12.
  bool corrects_velocity = false;

  /// beta = 1/4: unconditionally stable, conserves the energy of linear systems.
  static constexpr Newmark average_acceleration() { return {.beta = 0.25}; }
  /// beta = 1/6: smaller period error, stable for h <= 0.55 of the shortest period.
  static constexpr Newmark linear_acceleration() { return {.beta = 1.0 / 6.0}; }
  /// beta = 1/12 with corrected velocities: fourth order, stable for h <= 0.39 of the shortest period without damping
  /// (h w <= 2.45). Adapted steps take it up to h w = 1.8 and h c/m = 4, which is stable with damping too.
  static constexpr Newmark fourth_order() { return {.beta = 1.0 / 12.0, .corrects_velocity = true}; }

  /// Returns the scheme of every step; none if it is chosen step by step.
  [[nodiscard]] std::optional<StepScheme> scheme() const {
    if (!beta) return std::nullopt;
    return StepScheme{.beta = *beta, .corrects_velocity = corrects_velocity};
  }
  void check(const Check& check) const {
    check.that(!beta || (*beta > 0.0 && *beta <= 0.5), "integrator.beta", beta.value_or(0.25), "1", "> 0 and <= 0.5",
               "Use Newmark::average_acceleration(), linear_acceleration() or fourth_order().");
    check.that(!corrects_velocity || beta == fourth_order().beta, "integrator.beta", beta.value_or(0.25), "1",
               "1/12 with corrects_velocity", "Use Newmark::fourth_order().");
  }
  [[nodiscard]] std::string description() const {
    return "Newmark's method, beta = " + to_text(beta.value_or(0.25)) + ", gamma = 1/2" +
           (corrects_velocity ? ", velocities corrected" : "");
  }

  friend bool operator==(const Newmark&, const Newmark&) = default;
};

}  // namespace moat
