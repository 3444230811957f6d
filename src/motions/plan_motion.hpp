// Components of a ground motion: two horizontal ones at an angle to the building, and a vertical one.
#pragma once

#include <optional>

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
/// The user names which component is first; read_record() (motions/readers/record.hpp) finds it by azimuths. All start
/// at time 0. Of unequal sampling intervals the longer must be a multiple of the shortest, so that linear resampling is
/// exact; a shorter motion is continued by zeros.
struct PlanMotion {
  /// The horizontal components.
  GroundMotion first, second;
  /// > -360 deg, < 360 deg.
  Angle incidence{};
  /// Positive upwards.
  std::optional<GroundMotion> vertical{};
  /// A finite factor of the vertical component alone. Where it is given, scalings of the pair leave that component.
  std::optional<double> vertical_factor{};

  /// The components along x and y, and upwards, on the finest of their sampling intervals. Throws InputError for an
  /// angle outside its range, sampling intervals that are no multiples of the shortest, or a vertical_factor without
  /// vertical component.
  [[nodiscard]] GroundMotion resolved() const;
  operator GroundMotion() const { return resolved(); }  ///< As analyses take it.

  /// Returns the pair, turned by a further angle.
  [[nodiscard]] PlanMotion rotated(Angle angle) const;
  /// All components times one finite factor; without the vertical one if that has its own vertical_factor.
  [[nodiscard]] PlanMotion scaled_by(double factor) const;
  /// Scales as scaled_by() does: the larger of both horizontal peak accelerations becomes `target` > 0.
  [[nodiscard]] PlanMotion scaled_to_larger_pga(Acceleration target) const;
};

/// A motion along x and upwards, for models on a line: one component each, sampled as those of a PlanMotion. Later
/// factors multiply both; scale each before to give it a factor of its own.
///
///     script.run(model, with_vertical(horizontal.scaled_by(1.5), vertical));
///
/// Throws InputError for a motion of several components, and for sampling intervals of which the longer is no multiple
/// of the shorter.
[[nodiscard]] GroundMotion with_vertical(const GroundMotion& horizontal, const GroundMotion& vertical);

}  // namespace moat
