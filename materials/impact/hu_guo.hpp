// Impact law of Hu and Guo, also called the modified Hertz-damp law.
#pragma once

#include "materials/contact/viscous_hertz_law.hpp"

namespace moat {

struct HuGuoFactor {
  static constexpr std::string_view name = "HuGuo";
  static constexpr std::string_view alias = "ModifiedHertzDamp";
  static constexpr std::string_view formula = "z = 3 (1 - e)/(2 e)";
  static constexpr std::string_view assumption = "An approximation; delivers 0.646 for a restitution of 0.65.";
  static constexpr bool divides_by_restitution = true;

  static double of(double e) { return 1.5 * (1.0 - e) / e; }
};

/// Hu-Guo model: F = k d^1.5 (1 + z d'/v0) with z = 3 (1 - e)/(2 e), 0.001 <= e <= 1.
///
/// Source: Hu & Guo (2015), A dissipative contact force model for impact analysis in multibody dynamics.
///
/// The modified Hertz-damp model of Zhao, Liu & Li (2017) is the same law: it gives all ten cells of their Table 1,
/// column "model of this paper", within 0.0024. The text of that paper derives another force (Eq. 10 with Eq. 27:
/// ModifiedHertzDampPrinted), which cannot have produced the table. The restitution e' it delivers, ln((1 + z)/(1 - z
/// e')) = z (1 + e'), is close to e: e' = 0.799, 0.646, 0.380 for e = 0.80, 0.65, 0.40.
using HuGuo = ViscousHertzLaw<HuGuoFactor>;

/// The name of the same law in studies of pounding.
using ModifiedHertzDamp = HuGuo;

}  // namespace moat
