// Modified linear viscoelastic impact law.
#pragma once

#include <numbers>

#include "materials/contact/viscous_linear_contact.hpp"

namespace moat {

/// Modified linear viscoelastic model: F = k d + c d' on approach, F = k d on the way back, c = 2 xi sqrt(k m),
/// xi = (1 - e^2)/(e (e (pi - 2) + 2)).
///
/// Source: Mahmoud & Jankowski (2011), Modified linear viscoelastic model of earthquake-induced structural
/// pounding; m is the effective mass of the two bodies. Never pulls; the contact ends where the gap opens. The
/// restitution it delivers is exp(-a cot a), cos a = xi: 0.801, 0.654, 0.407 for e = 0.80, 0.65, 0.40. The force jumps
/// to c v0 at touch. Indentation and compression positive.
struct ModifiedLinearViscoelastic {
  static constexpr std::string_view name = "ModifiedLinearViscoelastic";
  static constexpr std::string_view formula = "damping on approach only; xi = (1 - e^2)/(e (e (pi - 2) + 2))";
  static constexpr std::string_view assumption =
      "Damping on approach only, the force jumps at touch; delivers 0.654 for a restitution of 0.65.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// e, the intended coefficient of restitution: 0.001 <= e <= 1, because the damping grows as 1/e.
  Required<Restitution> restitution;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check, least_restitution_in_divisor);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution({"stiffness", stiffness.si(), "N/m"}, restitution);
  }
  /// The law between two bodies of the given effective mass m1 m2/(m1 + m2) > 0 kg; a fixed wall is infinite.
  [[nodiscard]] ViscousLinearContact between(double effective_mass) const {
    const auto ratio_of = [](double e) { return (1.0 - e * e) / (e * (e * (std::numbers::pi - 2.0) + 2.0)); };
    return {.stiffness = stiffness.si(),
            .damping = damping_by_ratio(restitution, stiffness.si(), effective_mass, ratio_of),
            .approach_only = true};
  }
};

}  // namespace moat
