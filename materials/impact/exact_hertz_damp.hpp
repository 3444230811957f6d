// Hertz-damp impact law that delivers the intended restitution exactly.
#pragma once

#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "materials/impact_checks.hpp"
#include "materials/restitution_formulas.hpp"
#include "materials/viscous_hertz_contact.hpp"

namespace moat {

/// Exact Hertz-damp model: F = k d^1.5 (1 + z d'/v0) with the root z of ln((1 + z)/(1 - z e)) = z (1 + e).
///
/// Source: the equation follows from integrating the impact m d'' = -F once, exactly; Hunt & Crossley (1975) and
/// their successors approximate its root. The restitution of a free impact is e itself, for any k, masses and
/// approach speed from 1e-4 m/s up (least_approach_speed); slower impacts are more elastic: z = 0.37315,
/// 0.79310, 2.08250 for e = 0.80, 0.65, 0.40.
///
/// Indentation and compression positive. The contact ends where the force reaches zero or the gap opens,
/// in free impact always the latter.
struct ExactHertzDamp {
  static constexpr std::string_view name = "ExactHertzDamp";
  static constexpr std::string_view formula = "z solves ln((1 + z)/(1 - z e)) = z (1 + e)";

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
    return {stiffness.si(), damping_factor_of_viscous_hertz(restitution), separation(may_pull)};
  }
};

}  // namespace moat
