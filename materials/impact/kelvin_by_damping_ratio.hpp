// Kelvin impact law, given its damping ratio.
#pragma once

#include <cmath>
#include <optional>

#include "materials/contact/changed_law.hpp"
#include "materials/contact/restitution_formulas.hpp"
#include "materials/contact/viscous_linear_contact.hpp"

namespace moat {

/// Kelvin model (Kelvin-Voigt): F = k d + c d', c = 2 xi sqrt(k m), with the damping ratio xi itself. Kelvin
/// takes a restitution instead.
///
/// Source: Zhao, Liu & Li (2017), Eqs. 2-3; m is the effective mass of the two bodies. Delivered restitution:
/// exp(-2 a cot a), cos a = xi, if the contact ends where the force reaches zero (default);
/// exp(-pi xi/sqrt(1 - xi^2)) if it may pull until the gap opens. xi = 0.14 gives 0.667 and 0.641. The force
/// jumps to c v0 at touch. Indentation and compression positive.
struct KelvinByDampingRatio {
  static constexpr std::string_view name = "KelvinByDampingRatio";
  static constexpr std::string_view formula = "xi itself";
  static constexpr std::string_view assumption = "The force jumps at touch.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// xi >= 0, and < 1 if the contact may pull: beyond, it would never end.
  Required<double> damping_ratio;
  /// Whether the contact lasts until the gap opens, pulling before it does, as in the equations of the paper.
  bool may_pull = false;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.not_negative("damping_ratio", damping_ratio.value(), "1");
    check.that(!may_pull || damping_ratio < 1.0, "damping_ratio", damping_ratio, "1", "< 1 where may_pull is true",
               "A contact that pulls and is damped critically never ends.");
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"},
            {"damping_ratio", damping_ratio, "1"},
            {"may_pull", may_pull ? 1.0 : 0.0, "1"}};
  }
  /// The law between two bodies of the given effective mass m1 m2/(m1 + m2) > 0 kg; a fixed wall is infinite.
  [[nodiscard]] ViscousLinearContact between(double effective_mass) const {
    return {.stiffness = stiffness.si(),
            .damping = 2.0 * damping_ratio * std::sqrt(stiffness.si() * effective_mass),
            .separation = separation(may_pull)};
  }
};

/// Returns the restitution that the law delivers.
inline std::optional<double> restitution_of_law(const KelvinByDampingRatio& law) {
  return law.may_pull ? restitution_of_pulling_contact(law.damping_ratio)
                      : restitution_of_clamped_contact(law.damping_ratio);
}

/// Returns the law whose damping ratio delivers the changed restitution.
inline KelvinByDampingRatio with_restitution_change(KelvinByDampingRatio law, double change) {
  const double before = *restitution_of_law(law), after = changed_restitution(before, change);
  // Equal bits where nothing changes: the formulas are inverses but for round-off.
  if (after != before)
    law.damping_ratio =
        law.may_pull ? damping_ratio_of_pulling_contact(after) : damping_ratio_of_clamped_contact(after);
  return law;
}

}  // namespace moat
