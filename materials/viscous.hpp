// Linear dashpot.
#pragma once

#include "materials/response.hpp"

namespace moat {

/// F = damping * d'.
struct Viscous {
  static constexpr std::string_view name = "Viscous";

  /// > 0 N s/m.
  Required<DampingCoefficient> damping;

  using State = NoState;
  static constexpr bool linear_within_regimes = true;

  void check(const Check& check) const { check.positive("damping", damping); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"damping", damping.si(), "N s/m"}}; }
  Response evaluate(const State&, double, double rate, State&) const {
    return {damping.si() * rate, 0.0, damping.si()};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double rate) const { return damping.si() * rate * rate; }
  double linear_stiffness(StiffnessStage) const { return 0.0; }
};

}  // namespace moat
