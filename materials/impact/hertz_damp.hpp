// Hertz-damp impact law, due to Lankarani and Nikravesh.
#pragma once

#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "materials/impact_checks.hpp"
#include "materials/viscous_hertz_contact.hpp"

namespace moat {

/// Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with z = 3/4 (1 - e^2).
///
/// Source: Lankarani & Nikravesh (1990), A contact force model with hysteresis damping for impact analysis of
/// multibody systems, Eq. 31; under the name Hertz-damp in Muthukumar & DesRoches (2006) and Zhao, Liu & Li (2017),
/// Eqs. 6-8. It was derived for e near 1: the restitution e' it delivers, ln((1 + z)/(1 - z e')) =
/// z (1 + e'), is above e: e' = 0.847, 0.775, 0.702 for e = 0.80, 0.65, 0.40.
///
/// Indentation and compression positive. The contact ends where the force reaches zero or the gap opens,
/// in free impact always the latter.
struct HertzDamp {
  static constexpr std::string_view name = "HertzDamp";
  static constexpr std::string_view alias = "LankaraniNikravesh";
  static constexpr std::string_view formula = "z = 3/4 (1 - e^2)";

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0 < e <= 1.
  Required<double> restitution;
  /// Whether the force may turn negative while bodies in contact are drawn apart. Changes nothing in free impact.
  bool may_pull = false;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check_restitution(check, restitution);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m^1.5"},
            {"restitution", restitution, "1"},
            {"may_pull", may_pull ? 1.0 : 0.0, "1"}};
  }
  /// The law between two bodies; this one does not depend on their effective mass (kg).
  [[nodiscard]] ViscousHertzContact between(double /*effective_mass*/) const {
    return {stiffness.si(), 0.75 * (1.0 - restitution * restitution), separation(may_pull)};
  }
};

/// The name of the same law in multibody dynamics.
using LankaraniNikravesh = HertzDamp;

}  // namespace moat
