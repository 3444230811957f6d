// Impact law of Gonthier et al.
#pragma once

#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct GonthierFactor {
  static constexpr std::string_view name = "Gonthier";
  static constexpr std::string_view formula = "z = (1 - e^2)/e";
  static constexpr std::string_view assumption = "An approximation; delivers 0.623 for a restitution of 0.65.";
  static constexpr bool divides_by_restitution = true;

  static double of(double e) { return (1.0 - e * e) / e; }
};

/// Gonthier model: F = k d^1.5 (1 + z d'/v0) with z = (1 - e^2)/e, 0.001 <= e <= 1.
///
/// Source: Gonthier, McPhee, Lange & Piedboeuf (2004), A regularized contact model with asymmetric damping and
/// dwell-time dependent friction: an approximation of the exact factor over the whole range of e. The restitution
/// e' it delivers, ln((1 + z)/(1 - z e')) = z (1 + e'), is e' = 0.768, 0.623, 0.398 for e = 0.80, 0.65, 0.40.
using Gonthier = ViscousHertzLaw<GonthierFactor>;

}  // namespace moat
