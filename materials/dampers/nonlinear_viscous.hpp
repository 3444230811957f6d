// Fluid damper with a power of the velocity.
#pragma once

#include <cmath>

#include "materials/response.hpp"

namespace moat {

/// Fluid viscous damper:
///
///     F = C |v|^alpha sgn v,   rounded below v0:   F = C v/(v^2 + v0^2)^((1 - alpha)/2)
///
/// C has the unit N (s/m)^alpha, which no dimension of this library has: give the force at a reference speed,
/// C = reference_force/reference_speed^alpha. Bare |v|^alpha with alpha < 1 has an infinite slope at rest. A v0 of 1 %
/// of the peak speed takes 0.01 % of the energy of a cycle. Typical: alpha 0.3 to 0.5 beside isolators, 0.15 to 1 in
/// storeys; C from 0.3 to 3 MN (s/m)^alpha. Tension positive.
struct NonlinearViscous {
  static constexpr std::string_view name = "NonlinearViscous";
  static constexpr std::string_view formula = "F = C abs(v)^alpha sgn(v)";
  static constexpr std::string_view assumption = "Rounded at low speed, where the power law has an infinite slope.";

  /// > 0 N, at reference_speed.
  Required<Force> reference_force;
  /// 0.1 <= alpha <= 2.
  Required<double> exponent;
  /// > 0 m/s.
  Speed reference_speed = 1.0 * units::m / units::s;
  /// v0 > 0 m/s.
  Speed rounding_speed = 1.0 * units::mm / units::s;

  using State = NoState;
  static constexpr bool is_damper = true;

  static NonlinearViscous typical() {
    using namespace units;
    return {.reference_force = 1.5 * MN, .exponent = 0.3};
  }

  void check(const Check& check) const {
    check.positive("reference_force", reference_force);
    check.between("exponent", exponent, 0.1, 2.0, "1", "Fluid dampers have 0.15 to 1.");
    check.positive("reference_speed", reference_speed);
    check.positive("rounding_speed", rounding_speed, "Use 1 % of the peak speed or less.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"reference_force", reference_force.si(), "N"},
            {"exponent", exponent, "1"},
            {"reference_speed", reference_speed.si(), "m/s"},
            {"rounding_speed", rounding_speed.si(), "m/s"}};
  }
  Response evaluate(const State&, double, double rate, State&) const {
    const double square = rate * rate + rounding_speed.si() * rounding_speed.si();
    const double per_rate = coefficient() * std::pow(square, 0.5 * (exponent - 1.0));
    const double slope = (exponent * rate * rate + rounding_speed.si() * rounding_speed.si()) / square;
    return {per_rate * rate, 0.0, per_rate * slope};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State& state, double deformation, double rate) const {
    State trial;
    return evaluate(state, deformation, rate, trial).force * rate;
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

 private:
  [[nodiscard]] double coefficient() const { return reference_force.si() / std::pow(reference_speed.si(), exponent); }
};

}  // namespace moat
