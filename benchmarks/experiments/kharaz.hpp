// Oblique impacts of a sphere on a plane, with friction.
//
// A. H. Kharaz, D. A. Gorham, A. D. Salman, Powder Technology 120 (2001) 281; finite elements and an integration with
// constant tangential stiffness as test 4 of Y. C. Chung, J. Y. Ooi, Granular Matter 13 (2011) 643.
#pragma once

#include <optional>
#include <type_traits>

#include "elements/contact/corner_gap.hpp"

namespace moat::experiments {

/// Aluminium oxide, without spin before.
struct KharazSphere {
  static constexpr double radius = 2.5e-3;         ///< m
  static constexpr double mass = 2.61799e-4;       ///< kg
  static constexpr double inertia = 6.54498e-10;   ///< kg m^2
  static constexpr double hertz = 2.6749e10;       ///< N/m^1.5
  static constexpr double restitution = 0.98;      ///< along the normal
  static constexpr double friction = 0.092;        ///< mu
  static constexpr double speed = 3.9;             ///< m/s
  static constexpr double stiffness_ratio = 0.85;  ///< of the tangential to the normal stiffness
};

struct Rebound {
  double tangential_restitution = 0.0;  ///< velocity of the centre along the plane, after over before
  double spin = 0.0;                    ///< rad/s
  double angle = 0.0;                   ///< degrees from the normal, of the velocity of the point of contact
  double normal_restitution = 0.0;      ///< velocity of the centre along the normal, after over before
};

/// The tangential stiffness that counts in all of the contact: ratio times the normal tangent at the largest
/// indentation of an impact at this angle, degrees from the normal.
CornerFriction constant_stiffness(double angle);
/// Whether the friction of a corner also takes a ratio in place of the stiffness.
inline constexpr bool friction_takes_a_ratio = std::is_constructible_v<CornerFriction, double, double>;
/// The tangential stiffness that follows the normal tangent; none without friction_takes_a_ratio.
std::optional<CornerFriction> following_stiffness();

/// moat's rebound at this angle, above 0 and below 90 degrees from the normal.
Rebound rebound(double angle, const CornerFriction& friction);

}  // namespace moat::experiments
