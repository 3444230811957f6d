// Modified Hertz-damp impact law, as printed.
#pragma once

#include <cmath>

#include "materials/contact/root_damped_hertz_contact.hpp"

namespace moat {

/// Modified Hertz-damp model as its paper prints it: F = k d^1.5 + c d', c = 2 xi sqrt(k sqrt(d) m),
/// xi = sqrt(5) (1 - e^2)/(10 e^2).
///
/// Source: Zhao, Liu & Li (2017), Eq. 10 with Eq. 27; m is the effective mass of the two bodies. Its Table 1 was
/// computed with another force, which is ModifiedHertzDamp.
///
/// The paper does not say when the dashpot acts. It writes the force once, without Jankowski's distinction (Eq. 15),
/// and criticises that his force history is not smooth: this suggests damping throughout. It balances the energy over
/// one phase only, from d = 0 to the deepest point (Eqs. 14, 23): this suggests damping on approach only, the default
/// here. The restitution delivered, with cos a = 2 xi/sqrt(5), for e = 0.80, 0.65, 0.40:
///
///     approach_only              exp(-a cot a)               0.848, 0.692, 0.356
///     throughout                 exp(-2 a cot a)             0.719, 0.479, 0.127
///     throughout and may_pull    exp(-pi x/sqrt(1 - x^2))    0.701, 0.409, none: x = cos a must be below 1, e above
///                                                            0.409
///
/// Indentation and compression positive.
struct ModifiedHertzDampPrinted {
  static constexpr std::string_view name = "ModifiedHertzDampPrinted";
  static constexpr std::string_view formula =
      "damping on approach only, unless `.approach_only = false`; xi = sqrt(5) (1 - e^2)/(10 e^2)";
  static constexpr std::string_view assumption =
      "The force as its paper prints it; when the dashpot acts is a choice, by default on approach only.";

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0.001 <= e <= 1, because the damping grows as 1/e^2.
  Required<Restitution> restitution;
  /// Whether the dashpot acts only while the bodies approach; else throughout.
  bool approach_only = true;
  /// Whether the contact lasts until the gap opens, pulling before it does. Only if the dashpot acts throughout.
  bool may_pull = false;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check, least_restitution_in_divisor);
    check.that(!(may_pull && approach_only), "may_pull", may_pull, "1", "false where approach_only is true",
               "A dashpot that acts on approach only never pulls.");
    const double smallest = restitution.value().smallest();
    check.that(!may_pull || smallest >= 0.409, "restitution", smallest, "1", ">= 0.409 where the contact may pull",
               "A contact that pulls and is damped critically never ends.");
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution(
        {"stiffness", stiffness.si(), "N/m^1.5"}, restitution,
        {{"approach_only", approach_only ? 1.0 : 0.0, "1"}, {"may_pull", may_pull ? 1.0 : 0.0, "1"}});
  }
  /// The law between two bodies of the given effective mass m1 m2/(m1 + m2) > 0 kg; a fixed wall is infinite.
  [[nodiscard]] RootDampedHertzContact between(double effective_mass) const {
    const auto ratio_of = [](double e) { return std::sqrt(5.0) * (1.0 - e * e) / (10.0 * e * e); };
    return {.stiffness = stiffness.si(),
            .damping = damping_by_ratio(restitution, stiffness.si(), effective_mass, ratio_of),
            .approach_only = approach_only,
            .separation = separation(may_pull)};
  }
};

}  // namespace moat
