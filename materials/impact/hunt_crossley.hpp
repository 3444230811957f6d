// Impact law of Hunt and Crossley.
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

/// Hunt-Crossley model: F = k d^1.5 (1 + z d'/v0) with z = 3/2 (1 - e).
///
/// Source: Hunt & Crossley (1975), Coefficient of restitution interpreted as damping in vibroimpact: lambda =
/// 3/2 alpha k with e = 1 - alpha v0. It was derived for e near 1: the restitution e' it delivers,
/// ln((1 + z)/(1 - z e')) = z (1 + e'), is above e: e' = 0.833, 0.739, 0.620 for e = 0.80,
/// 0.65, 0.40.
///
/// Indentation and compression positive. The contact ends where the force reaches zero or the gap opens,
/// in free impact always the latter.
struct HuntCrossley {
  static constexpr std::string_view name = "HuntCrossley";
  static constexpr std::string_view formula = "z = 3/2 (1 - e)";

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
    return {stiffness.si(), 1.5 * (1.0 - restitution), separation(may_pull)};
  }
};

}  // namespace moat
