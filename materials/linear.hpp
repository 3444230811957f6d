// Linear spring with an optional dashpot beside it.
#pragma once

#include "materials/response.hpp"

namespace moat {

/// F = stiffness * d + damping * d'. Tension positive.
struct Linear {
  static constexpr std::string_view name = "Linear";

  /// > 0 N/m.
  Required<Stiffness> stiffness;
  /// >= 0 N s/m.
  DampingCoefficient damping{};

  using State = NoState;
  static constexpr bool linear_within_regimes = true;

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.not_negative("damping", damping);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"}, {"damping", damping.si(), "N s/m"}};
  }
  Response evaluate(const State&, double deformation, double rate, State&) const {
    return {stiffness.si() * deformation + damping.si() * rate, stiffness.si(), damping.si()};
  }
  double stored_energy(const State&, double deformation) const {
    return 0.5 * stiffness.si() * deformation * deformation;
  }
  double dissipation_rate(const State&, double, double rate) const { return damping.si() * rate * rate; }
  double linear_stiffness(StiffnessStage) const { return stiffness.si(); }
};

}  // namespace moat
