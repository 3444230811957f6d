// Bilinear impact law, due to Muthukumar and DesRoches.
#pragma once

#include <cmath>

#include "materials/contact/bilinear_contact.hpp"

namespace moat {

/// Bilinear truss contact: loads with K1 to d_y = a d_m, then with K2; its loop to d_m loses the energy of a Hertz
/// contact of restitution e (materials/contact/bilinear_contact.hpp).
///
///     K_eff = k_h sqrt(d_m)    dE = k_h d_m^2.5 (1 - e^2)/2.5
///     K1 = K_eff + dE/(a d_m^2)    K2 = K_eff - dE/((1 - a) d_m^2)
///
/// The law of practice with OpenSees (ImpactMaterial, see from_stiffnesses()). The restitution is right only where the
/// indentation reaches d_m: the table of impacts lists the one that it delivers. Typical in use: k_h = 2.747e10 N/m^1.5
/// (25 000 kip/in^1.5), e 0.6 to 0.7, d_m 0.6 to 25 mm. Source: Muthukumar & DesRoches (2006), A Hertz contact model
/// with non-linear damping for pounding simulation.
struct BilinearImpact {
  static constexpr std::string_view name = "BilinearImpact";
  static constexpr std::string_view formula = "K1 = K_eff + dE/(a d_m^2), K2 = K_eff - dE/((1 - a) d_m^2)";
  static constexpr std::string_view assumption =
      "Its restitution is right only where the indentation reaches the design value d_m.";

  /// k_h > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0 < e <= 1.
  Required<Restitution> restitution;
  /// d_m > 0 m: the largest indentation that is expected.
  Required<Length> expected_indentation;
  /// 0 < a <= 0.5: d_y over d_m.
  double yield_share = 0.1;

  /// The law of these stiffnesses, K1 > K2 > 0 N/m and d_y > 0 m, as ImpactMaterial of OpenSees has them:
  /// d_m = d_y/a, k_h sqrt(d_m) = a K1 + (1 - a) K2, and e of dE = a (1 - a) (K1 - K2) d_m^2. Throws InputError for bad
  /// ones, and where more energy would be lost than is put in.
  static BilinearImpact from_stiffnesses(Stiffness loading, Stiffness yielding, Length yield_indentation,
                                         double yield_share = 0.1) {
    const Check check{"BilinearImpact::from_stiffnesses", ""};
    check.positive("yielding", yielding);
    check.that(loading > yielding, "loading", loading.si(), "N/m", "above yielding");
    check.positive("yield_indentation", yield_indentation);
    check.above_up_to("yield_share", yield_share, 0.0, 0.5, "1");
    const double a = yield_share, effective = a * loading.si() + (1.0 - a) * yielding.si();
    const double lost = 2.5 * a * (1.0 - a) * (loading - yielding).si() / effective;
    check.that(lost < 1.0, "loading", loading.si(), "N/m", "nearer to yielding, or yield_share smaller",
               "The energy lost to d_y / yield_share exceeds that of the Hertz contact.");
    const Length expected = (1.0 / a) * yield_indentation;
    return {.stiffness = HertzStiffness{effective / std::sqrt(expected.si())},
            .restitution = std::sqrt(1.0 - lost),
            .expected_indentation = expected,
            .yield_share = a};
  }

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check);
    check.positive("expected_indentation", expected_indentation);
    check.above_up_to("yield_share", yield_share, 0.0, 0.5, "1", "0.1 is usual.");
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution(
        {"stiffness", stiffness.si(), "N/m^1.5"}, restitution,
        {{"expected_indentation", expected_indentation.si(), "m"}, {"yield_share", yield_share, "1"}});
  }
  /// The law between two bodies; it does not depend on their mass.
  [[nodiscard]] BilinearContact between(double) const {
    const double largest = expected_indentation.si(), effective = stiffness.si() * std::sqrt(largest);
    const auto lost_of = [effective](double e) { return effective * (1.0 - e * e) / 2.5; };  // dE/d_m^2
    const Restitution& e = restitution;
    const double lost = lost_of(e.at(1.0));
    BilinearContact contact{.loading_stiffness = effective + lost / yield_share,
                            .yielding_stiffness = effective - lost / (1.0 - yield_share),
                            .yield_indentation = yield_share * largest,
                            .yield_share = yield_share};
    if (!e.is_constant())
      contact.difference = ContactDamping{
          e, [lost_of, a = yield_share](double at_touch) { return lost_of(at_touch) / (a * (1.0 - a)); }};
    return contact;
  }
};

}  // namespace moat
