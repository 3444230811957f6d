// Non-linear viscoelastic impact law.
#pragma once

#include <cmath>
#include <numbers>

#include "materials/contact/root_damped_hertz_contact.hpp"

namespace moat {

/// Non-linear viscoelastic model: F = k d^1.5 + c d' on approach, F = k d^1.5 on the way back,
/// c = 2 xi sqrt(k sqrt(d) m), xi = 9 sqrt(5) (1 - e^2)/(2 e (e (9 pi - 16) + 16)).
///
/// Source: Jankowski (2005, 2006); Zhao, Liu & Li (2017), Eqs. 9-11; m is the effective mass of the two bodies.
/// Never pulls; the contact ends where the gap opens. The restitution it delivers is exp(-a cot a), cos a =
/// 2 xi/sqrt(5): 0.799, 0.647, 0.393 for e = 0.80, 0.65, 0.40. (The column of this name in Table 1 of the paper
/// was computed with Ye2009.) Indentation and compression positive.
struct NonlinearViscoelastic {
  static constexpr std::string_view name = "NonlinearViscoelastic";
  static constexpr std::string_view formula =
      "damping on approach only; xi = 9 sqrt(5) (1 - e^2)/(2 e (e (9 pi - 16) + 16))";
  static constexpr std::string_view assumption = "Damping on approach only; delivers 0.647 for a restitution of 0.65.";

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0.001 <= e <= 1, because the damping grows as 1/e.
  Required<Restitution> restitution;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check, least_restitution_in_divisor);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution({"stiffness", stiffness.si(), "N/m^1.5"}, restitution);
  }
  /// The law between two bodies of the given effective mass m1 m2/(m1 + m2) > 0 kg; a fixed wall is infinite.
  [[nodiscard]] RootDampedHertzContact between(double effective_mass) const {
    const auto ratio_of = [](double e) {
      return 4.5 * std::sqrt(5.0) * (1.0 - e * e) / (e * (e * (9.0 * std::numbers::pi - 16.0) + 16.0));
    };
    return {.stiffness = stiffness.si(),
            .damping = damping_by_ratio(restitution, stiffness.si(), effective_mass, ratio_of),
            .approach_only = true};
  }
};

}  // namespace moat
