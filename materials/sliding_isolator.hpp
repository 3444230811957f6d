// A slider with friction beside a restoring spring.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "materials/friction/friction_models.hpp"
#include "materials/response.hpp"

namespace moat {

/// The force of a slider with friction beside a linear restoring spring: pendulums and flat sliders
/// (materials/isolation) make one of these from their parameters and the weight that they carry.
///
///     F = k_r d + q,    q = k_0 (d - s) while it sticks,    q = +-mu(|v|) N while it slides,    s = slip
///
/// Stick and slip are regimes whose ends are located: it slides where |d - s| reaches mu N/k_0, and sticks where its
/// rate turns. Within a regime the force is smooth in d and v. Stored energy: k_r d^2/2 + q^2/(2 k_0). Tension
/// positive.
struct SlidingIsolator {
  static constexpr std::string_view name = "SlidingIsolator";

  double restoring_stiffness = 0.0;  ///< k_r >= 0 N/m
  double elastic_stiffness = 0.0;    ///< k_0 > 0 N/m
  double normal_force = 0.0;         ///< N > 0 N
  Friction friction;                 ///< Friction of the surface.

  struct State {
    double slip = 0.0;            ///< m
    double friction_force = 0.0;  ///< q, N
    int direction = 0;            ///< of sliding: -1, +1; 0: sticks

    friend bool operator==(const State&, const State&) = default;
  };

  static constexpr std::array<ReportedQuantity, 2> quantities{{{"friction_coefficient", "1"}, {"isolator_slip", "m"}}};

  /// A rate enters the regime margin as the distance in this time, s.
  static constexpr double time_of_rate = 1.0;
  /// Sliding begins this much beyond the limit, relative: the end of a stick must not be switched by round-off.
  static constexpr double threshold = 1e-9;

  /// With friction that does not depend on speed.
  [[nodiscard]] bool is_linear_within_regimes() const { return friction.is_constant(); }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    trial = committed;
    if (committed.direction == 0) {
      trial.friction_force = elastic_stiffness * (deformation - committed.slip);
      return {restoring_stiffness * deformation + trial.friction_force, restoring_stiffness + elastic_stiffness, 0.0};
    }
    const FrictionCoefficient mu = coefficient(committed.direction * rate);
    trial.friction_force = committed.direction * mu.value * normal_force;
    trial.slip = deformation - trial.friction_force / elastic_stiffness;
    return {restoring_stiffness * deformation + trial.friction_force, restoring_stiffness, mu.slope * normal_force};
  }
  double stored_energy(const State& committed, double deformation) const {
    return 0.5 * restoring_stiffness * deformation * deformation +
           0.5 * committed.friction_force * committed.friction_force / elastic_stiffness;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.direction * rate <= 0.0) return 0.0;
    return coefficient(std::abs(rate)).value * normal_force * std::abs(rate);
  }
  /// Exact for friction that does not depend on speed, of second order else: mean q times the change of slip. The slip
  /// runs back where the friction grows faster than k_0 times the move; that much energy is stored.
  double dissipated_energy(const State& from, const State& to) const {
    return 0.5 * (from.friction_force + to.friction_force) * (to.slip - from.slip);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return restoring_stiffness + (stage == StiffnessStage::initial ? elastic_stiffness : 0.0);
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.direction != 0) return committed.direction * rate * time_of_rate;
    return limit(std::abs(rate)) / elastic_stiffness * (1.0 + threshold) - std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    const int direction = committed.direction != 0 ? committed.direction : deformation > committed.slip ? 1 : -1;
    const double force = direction * limit(committed.direction != 0 ? 0.0 : std::abs(rate));
    return {deformation - force / elastic_stiffness, force, committed.direction != 0 ? 0 : direction};
  }

  ReportedValue quantity(std::size_t index, const State& state, double, double rate, double second_rate) const {
    // The rate at the end of a slide may have the other sign by round-off.
    const int direction = state.direction != 0 ? state.direction : rate < 0.0 ? -1 : 1;
    const FrictionCoefficient mu = coefficient(direction * rate);
    const double mu_rate = mu.slope * direction * second_rate;
    if (index == 0) return {mu.value, mu_rate};
    return {state.slip,
            state.direction == 0 ? 0.0 : rate - state.direction * mu_rate * normal_force / elastic_stiffness};
  }

 private:
  [[nodiscard]] double limit(double speed) const { return coefficient(speed).value * normal_force; }
  // A step may overshoot the turn of the rate: the coefficient goes on along its tangent, so that it stays smooth.
  [[nodiscard]] FrictionCoefficient coefficient(double speed) const {
    FrictionCoefficient mu = friction.at(std::max(speed, 0.0), normal_force);
    if (speed < 0.0) mu.value += mu.slope * speed;
    return mu;
  }
};

}  // namespace moat
