// Hertz-damp impact law.
#pragma once

#include "base/check.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "materials/viscous_hertz.hpp"

namespace moat {

/// Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with z = 3/4 (1 - e^2).
///
/// Source: Zhao, Liu & Li (2017), Eqs. 6-8; Muthukumar & DesRoches (2006); the same factor is due to
/// Lankarani & Nikravesh (1990). It was derived for e near 1: what it delivers, ln((1 + z)/(1 - z e')) =
/// z (1 + e'), is above what is asked for: e' = 0.847, 0.775, 0.702 for e = 0.80, 0.65, 0.40.
/// Indentation and compression positive; never pulls.
struct HertzDamp {
  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the coefficient of restitution asked for: 0 < e <= 1.
  Required<double> restitution;

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.above_up_to("restitution", restitution.value(), 0.0, 1.0, "1",
                      "It is the speed after the impact over the speed before.");
  }
  /// The law between two bodies; this one does not depend on their effective mass (kg).
  [[nodiscard]] ViscousHertz between(double /*effective_mass*/) const {
    return {stiffness.si(), 0.75 * (1.0 - restitution * restitution)};
  }
};

}  // namespace moat
