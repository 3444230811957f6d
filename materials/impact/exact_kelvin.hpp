// Kelvin impact law that delivers the intended restitution exactly.
#pragma once

#include "materials/contact/restitution_formulas.hpp"
#include "materials/contact/viscous_linear_contact.hpp"

namespace moat {

/// Exact Kelvin model: F = k d + c d', c = 2 xi sqrt(k m), with the root xi of e = exp(-2 a cot a), cos a = xi.
///
/// Source: m d'' = -F integrated exactly up to where the force reaches zero and the contact ends; beyond critical
/// damping, e < exp(-2) = 0.1353, a = i acosh xi. m is the effective mass of the two bodies. The restitution of a
/// free impact is e itself, for any k, masses and approach speed. If the contact may pull until the gap opens,
/// xi = -ln e/sqrt(pi^2 + ln^2 e) delivers e, and is taken. The force jumps to c v0 at touch. Indentation and
/// compression positive.
struct ExactKelvin {
  static constexpr std::string_view name = "ExactKelvin";
  static constexpr std::string_view formula = "xi solves e = exp(-2 a cot a), cos a = xi";
  static constexpr std::string_view assumption = "The force jumps at touch. Delivers its restitution in free impact.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// e, the intended coefficient of restitution: 0 < e <= 1.
  Required<Restitution> restitution;
  /// Whether the contact lasts until the gap opens, pulling before it does. e is delivered either way.
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
            .damping = damping_by_ratio(restitution, stiffness.si(), effective_mass,
                                        may_pull ? damping_ratio_of_pulling_contact : damping_ratio_of_clamped_contact),
            .separation = separation(may_pull)};
  }
};

}  // namespace moat
