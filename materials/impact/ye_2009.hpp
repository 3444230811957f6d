// Impact law of Ye, Li and Zhu.
#pragma once

#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct Ye2009Factor {
  static constexpr std::string_view name = "Ye2009";
  static constexpr std::string_view formula = "z = 8 (1 - e)/(5 e)";
  static constexpr std::string_view assumption = "An approximation; delivers 0.630 for a restitution of 0.65.";
  static constexpr bool divides_by_restitution = true;

  static double of(double e) { return 1.6 * (1.0 - e) / e; }
};

/// Corrected Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with z = 8 (1 - e)/(5 e), 0.001 <= e <= 1.
///
/// Source: Ye, Li & Zhu (2009), A note on the Hertz contact model with nonlinear damping for pounding simulation;
/// the same factor is due to Flores et al. (2011). The column "non-linear viscoelastic model" of Zhao, Liu & Li
/// (2017), Table 1, was computed with it. The restitution e' it delivers, ln((1 + z)/(1 - z e')) = z (1 + e'), is
/// somewhat below e: e' = 0.789, 0.630, 0.363 for e = 0.80, 0.65, 0.40.
using Ye2009 = ViscousHertzLaw<Ye2009Factor>;

}  // namespace moat
