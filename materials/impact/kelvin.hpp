// Kelvin impact law, due to Anagnostopoulos.
#pragma once

#include "materials/contact/restitution_formulas.hpp"
#include "materials/contact/viscous_linear_contact.hpp"

namespace moat {

/// Kelvin model (Kelvin-Voigt): F = k d + c d', c = 2 xi sqrt(k m), with the damping ratio xi from the
/// restitution: xi = -ln e/sqrt(pi^2 + ln^2 e). KelvinByDampingRatio takes xi itself.
///
/// Source: Anagnostopoulos (1988), Pounding of buildings in series during earthquakes, as the linear viscoelastic
/// model; Zhao, Liu & Li (2017), Eqs. 2-4; m is the effective mass of the two bodies. The formula for xi holds
/// if the contact may pull until the gap opens: then e is delivered exactly. By default the contact ends where
/// the force reaches zero, and delivers more: e' = 0.808, 0.675, 0.472 for e = 0.80, 0.65, 0.40; ExactKelvin
/// delivers e without pulling. The force jumps to c v0 at touch. Indentation and compression positive.
struct Kelvin {
  static constexpr std::string_view name = "Kelvin";
  static constexpr std::string_view alias = "Anagnostopoulos";
  static constexpr std::string_view formula = "xi = -ln e/sqrt(pi^2 + ln^2 e)";
  static constexpr std::string_view assumption =
      "The force jumps at touch. Without pulling it delivers more than it is given: 0.675 for 0.65.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// e, the intended coefficient of restitution: 0 < e <= 1.
  Required<Restitution> restitution;
  /// Whether the contact lasts until the gap opens, pulling before it does, as in the equations of the paper.
  bool may_pull = false;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution({"stiffness", stiffness.si(), "N/m"}, restitution,
                            {{"may_pull", may_pull ? 1.0 : 0.0, "1"}});
  }
  /// The law between two bodies of the given effective mass m1 m2/(m1 + m2) > 0 kg; a fixed wall is infinite.
  [[nodiscard]] ViscousLinearContact between(double effective_mass) const {
    return {.stiffness = stiffness.si(),
            .damping = damping_by_ratio(restitution, stiffness.si(), effective_mass, damping_ratio_of_pulling_contact),
            .separation = separation(may_pull)};
  }
};

/// The name of the same law after its author.
using Anagnostopoulos = Kelvin;

}  // namespace moat
