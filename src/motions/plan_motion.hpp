// Two horizontal components of a ground motion, at an angle to the building.
#pragma once

#include <vector>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Two components of a motion, at right angles, at an angle of incidence to the model:
///
///        y ^   second        a_x = a_1 cos b - a_2 sin b
///          |  /              a_y = a_1 sin b + a_2 cos b
///          | /  _ first
///          |/_-'  ) b        b = incidence, counter-clockwise from +x to the first component
///          +----------> x
///
/// Give it wherever a GroundMotion is taken; the model must be in plan.
///
///     script.run(model, PlanMotion{fault_normal, fault_parallel, 30 * deg});
///
/// The user names which component is first: azimuths in headers of files are not trusted. Both start at time 0. Of
/// unequal sampling intervals the longer must be a multiple of the shorter, so that linear resampling is exact; a
/// shorter motion is continued by zeros.
struct PlanMotion {
  /// The components, with as many samples at the same interval.
  GroundMotion first, second;
  /// > -360 deg, < 360 deg.
  Angle incidence{};

  /// The components along x and y, on the finer of both sampling intervals. Throws InputError for an angle outside
  /// its range or sampling intervals that do not divide each other.
  [[nodiscard]] GroundMotion resolved() const;
  operator GroundMotion() const { return resolved(); }  ///< As analyses take it.

  /// Returns the pair, turned by a further angle.
  [[nodiscard]] PlanMotion rotated(Angle angle) const { return {first, second, incidence + angle}; }
  /// Both components times one finite factor.
  [[nodiscard]] PlanMotion scaled_by(double factor) const;
  /// Both components times one factor: the larger of their peak accelerations becomes `target` > 0.
  [[nodiscard]] PlanMotion scaled_to_larger_pga(Acceleration target) const;
};

/// Spectral accelerations of a pair of components in the direction that makes each of them largest (RotD100): the
/// largest resultant over time of an oscillator's pseudo-acceleration, m/s^2, one for each period (> 0 s), by steps of
/// 1 degree. `damping_ratio` >= 0, < 1. Boore 2010.
[[nodiscard]] std::vector<double> maximum_direction_spectrum(const PlanMotion& motion, const std::vector<Time>& periods,
                                                             double damping_ratio);

}  // namespace moat
