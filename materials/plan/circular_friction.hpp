// Friction with a limit of two components that may change.
#pragma once

#include "materials/saturating_slip.hpp"

namespace moat {

/// Friction at the end of a step, N, inside or on a circle whose radius L may change, with its derivatives:
///
///     q' = k_e u' inside |q| < L, and on the circle with slip along q
///
/// A circle that shrank takes the friction along at once. The direction turns with the mean of the circles at both
/// ends.
struct CircularFriction {
  SaturatingSlip::Step step;         ///< of q/L
  PlanVector force{};                ///< q, N
  PlanMatrix by_increment{};         ///< N/m
  PlanMatrix by_rate{};              ///< by the rate at the end, N s/m
  PlanMatrix by_force_before{};      ///< by q at the start
  PlanVector by_limit{}, by_mean{};  ///< by L at the end, and by the mean of L

  /// From `before`, N, by an increment, m, with these rates at both ends, m/s; `limit` and `mean` of L > 0 N and
  /// `elastic` stiffness k_e > 0 N/m. `advance(slip, z0)` returns the step of a SaturatingSlip from z0.
  template <class Advance>
  static CircularFriction after(PlanVector before, double limit, double mean, double elastic, const Advance& advance) {
    const double size = length(before);
    const bool shrank = size > limit;
    const PlanVector z0 = before / (shrank ? size : limit);
    const SaturatingSlip slip{SaturatingSlip::Begins::on_the_circle, mean / elastic, limit / elastic};
    const SaturatingSlip::Step step = advance(slip, z0);
    const PlanMatrix unit = PlanMatrix::diagonal(1.0);
    // The step depends on the mean and on its ratio to the limit.
    const double ratio = limit / mean;
    CircularFriction friction{.step = step,
                              .force = limit * step.z,
                              .by_increment = limit * step.by_increment,
                              .by_rate = limit * step.by_rate,
                              .by_force_before = step.by_start,
                              .by_limit = step.z + ratio * step.by_stretch,
                              .by_mean = -ratio * (step.by_scale + ratio * step.by_stretch)};
    if (shrank)
      friction.by_force_before = limit / size * step.by_start * (unit + -1.0 * PlanMatrix::product(z0, z0));
    else
      friction.by_limit = friction.by_limit - step.by_start * z0;
    return friction;
  }
};

}  // namespace moat
