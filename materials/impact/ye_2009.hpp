// Impact law of Ye, Li and Zhu.
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

/// Corrected Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with z = 8 (1 - e)/(5 e).
///
/// Source: Ye, Li & Zhu (2009), A note on the Hertz contact model with nonlinear damping for pounding simulation;
/// the same factor is due to Flores et al. (2011). The column "non-linear viscoelastic model" of Zhao, Liu & Li
/// (2017), Table 1, was computed with it. The restitution e' it delivers, ln((1 + z)/(1 - z e')) = z (1 + e'), is
/// somewhat below e: e' = 0.789, 0.630, 0.363 for e = 0.80, 0.65, 0.40.
///
/// Indentation and compression positive. The contact ends where the force reaches zero or the gap opens,
/// in free impact always the latter.
struct Ye2009 {
  static constexpr std::string_view name = "Ye2009";
  static constexpr std::string_view formula = "z = 8 (1 - e)/(5 e)";

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0.001 <= e <= 1, because the damping grows as 1/e.
  Required<double> restitution;
  /// Whether the force may turn negative while bodies in contact are drawn apart. Changes nothing in free impact.
  bool may_pull = false;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check_restitution_in_divisor(check, restitution);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m^1.5"},
            {"restitution", restitution, "1"},
            {"may_pull", may_pull ? 1.0 : 0.0, "1"}};
  }
  /// The law between two bodies; this one does not depend on their effective mass (kg).
  [[nodiscard]] ViscousHertzContact between(double /*effective_mass*/) const {
    return {stiffness.si(), 1.6 * (1.0 - restitution) / restitution, separation(may_pull)};
  }
};

}  // namespace moat
