// Hertz-damp impact law that delivers the intended restitution exactly.
#pragma once

#include "materials/contact/restitution_formulas.hpp"
#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct ExactHertzDampFactor {
  static constexpr std::string_view name = "ExactHertzDamp";
  static constexpr std::string_view formula = "z solves ln((1 + z)/(1 - z e)) = z (1 + e)";
  static constexpr std::string_view assumption =
      "Delivers its restitution in free impact at approach speeds from 1e-4 m/s up.";
  static constexpr bool divides_by_restitution = true;

  static double of(double e) { return damping_factor_of_viscous_hertz(e); }
};

/// Exact Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with the root z of ln((1 + z)/(1 - z e)) = z (1 + e),
/// 0.001 <= e <= 1.
///
/// Source: the equation follows from integrating the impact m d'' = -F once, exactly; Hunt & Crossley (1975) and
/// their successors approximate its root. The restitution of a free impact is e itself, for any k, masses and
/// approach speed from 1e-4 m/s up (least_approach_speed); slower impacts are more elastic: z = 0.37315,
/// 0.79310, 2.08250 for e = 0.80, 0.65, 0.40.
using ExactHertzDamp = ViscousHertzLaw<ExactHertzDampFactor>;

}  // namespace moat
