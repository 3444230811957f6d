// Hertz-damp impact law, due to Lankarani and Nikravesh.
#pragma once

#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct HertzDampFactor {
  static constexpr std::string_view name = "HertzDamp";
  static constexpr std::string_view alias = "LankaraniNikravesh";
  static constexpr std::string_view formula = "z = 3/4 (1 - e^2)";
  static constexpr std::string_view assumption =
      "Derived for restitutions near 1; delivers more than it is given: 0.775 for 0.65.";
  static constexpr bool divides_by_restitution = false;

  static double of(double e) { return 0.75 * (1.0 - e * e); }
};

/// Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with z = 3/4 (1 - e^2), 0 < e <= 1.
///
/// Source: Lankarani & Nikravesh (1990), A contact force model with hysteresis damping for impact analysis of
/// multibody systems, Eq. 31; under the name Hertz-damp in Muthukumar & DesRoches (2006) and Zhao, Liu & Li (2017),
/// Eqs. 6-8. It was derived for e near 1: the restitution e' it delivers, ln((1 + z)/(1 - z e')) =
/// z (1 + e'), is above e: e' = 0.847, 0.775, 0.702 for e = 0.80, 0.65, 0.40.
using HertzDamp = ViscousHertzLaw<HertzDampFactor>;

/// The name of the same law in multibody dynamics.
using LankaraniNikravesh = HertzDamp;

}  // namespace moat
