// Impact law of Hunt and Crossley.
#pragma once

#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct HuntCrossleyFactor {
  static constexpr std::string_view name = "HuntCrossley";
  static constexpr std::string_view formula = "z = 3/2 (1 - e)";
  static constexpr std::string_view assumption =
      "Derived for restitutions near 1; delivers more than it is given: 0.739 for 0.65.";
  static constexpr bool divides_by_restitution = false;

  static double of(double e) { return 1.5 * (1.0 - e); }
};

/// Hunt-Crossley model: F = k d^1.5 (1 + z d'/v0) with z = 3/2 (1 - e), 0 < e <= 1.
///
/// Source: Hunt & Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact: lambda =
/// 3/2 alpha k with e = 1 - alpha v0. It was derived for e near 1: the restitution e' it delivers,
/// ln((1 + z)/(1 - z e')) = z (1 + e'), is above e: e' = 0.833, 0.739, 0.620 for e = 0.80,
/// 0.65, 0.40.
using HuntCrossley = ViscousHertzLaw<HuntCrossleyFactor>;

}  // namespace moat
