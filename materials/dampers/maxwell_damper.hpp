// Fluid damper on an elastic brace.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/response.hpp"

namespace moat {

/// Fluid viscous damper in series with its brace:
///
///     o--/\/\/--[ |---o      F = K (d - x),    dx/dt = g(F) = sgn F (|F|/C)^(1/alpha)
///       brace K  damper
///
/// C as in NonlinearViscous: reference_force/reference_speed^alpha. The force follows by the trapezoidal rule over a
/// step of h, F1 + (K h/2) g(F1) = F0 + K (d1 - d0) - (K h/2) g(F0), which has one root. Where the rule would ring, K h
/// g'/2 > 4 at the start of the step, the backward Euler rule for dF/dt = K (dd/dt - g(F)) takes its place: the force
/// then follows the rate at the end, as without a brace. The damper is without force at the start. Stored energy F^2/(2
/// K). Typical: K 50 to 500 MN/m. Source: Akcelyan & Lignos, ViscousDamper of OpenSees. Tension positive.
struct MaxwellDamper {
  static constexpr std::string_view name = "MaxwellDamper";
  static constexpr std::string_view formula = "F = K (d - x), dx/dt = (F/C)^(1/alpha)";
  static constexpr std::string_view assumption = "Without force at the start.";

  /// K > 0 N/m.
  Required<Stiffness> brace_stiffness;
  /// > 0 N, at reference_speed.
  Required<Force> reference_force;
  /// 0.1 <= alpha <= 1.
  Required<double> exponent;
  /// > 0 m/s.
  Speed reference_speed = 1.0 * units::m / units::s;

  struct State {
    double piston = 0.0;        ///< x, m
    double force = 0.0;         ///< N
    bool follows_rate = false;  ///< the brace has relaxed: dF/dt is that of g(F) = dd/dt

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr bool is_damper = true;

  static MaxwellDamper typical() {
    using namespace units;
    return {.brace_stiffness = 100 * MN / m, .reference_force = 1.5 * MN, .exponent = 0.3};
  }

  void check(const Check& check) const {
    check.positive("brace_stiffness", brace_stiffness, "Without a brace take NonlinearViscous.");
    check.positive("reference_force", reference_force);
    check.between("exponent", exponent, 0.1, 1.0, "1", "Fluid dampers have 0.15 to 1.");
    check.positive("reference_speed", reference_speed);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"brace_stiffness", brace_stiffness.si(), "N/m"},
            {"reference_force", reference_force.si(), "N"},
            {"exponent", exponent, "1"},
            {"reference_speed", reference_speed.si(), "m/s"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, Interval interval, State& trial) const {
    const double stiffness = brace_stiffness.si(), h = interval.length;
    if (h == 0.0) {
      trial = committed;
      return {committed.force, stiffness, 0.0};
    }
    constexpr double rings = 4.0;
    const bool backward = 0.5 * stiffness * h * slope(committed.force) > rings;
    const double weight = backward ? h : 0.5 * h, path = interval.path(deformation);
    const double moved = backward ? h * rate : path - 0.5 * h * speed(committed.force);
    trial.force = solve(committed.force + stiffness * moved, stiffness * weight);
    trial.piston = committed.piston + path - (trial.force - committed.force) / stiffness;
    trial.follows_rate = backward && stiffness * h * slope(trial.force) > rings;
    const double tangent = stiffness / (1.0 + stiffness * weight * slope(trial.force));
    return {trial.force, backward ? 0.0 : tangent, backward ? h * tangent : 0.0};
  }
  double force_rate(const State& state, double, double rate, double second_rate) const {
    if (state.follows_rate) return second_rate / slope(state.force);
    return brace_stiffness.si() * (rate - speed(state.force));
  }
  double stored_energy(const State& committed, double) const {
    return 0.5 * committed.force * committed.force / brace_stiffness.si();
  }
  double dissipation_rate(const State& committed, double, double) const {
    return committed.force * speed(committed.force);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return 0.5 * (from.force + to.force) * (to.piston - from.piston);
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

 private:
  // g(F), m/s, and its slope.
  [[nodiscard]] double speed(double force) const {
    return std::copysign(reference_speed.si() * std::pow(std::abs(force) / reference_force.si(), 1.0 / exponent),
                         force);
  }
  [[nodiscard]] double slope(double force) const {
    return reference_speed.si() / (exponent * reference_force.si()) *
           std::pow(std::abs(force) / reference_force.si(), 1.0 / exponent - 1.0);
  }
  // F + weight g(F) = total. For positive forces the left side is convex and rises: Newton's method from above falls to
  // the root without overshoot.
  [[nodiscard]] double solve(double total, double weight) const {
    const double size = std::abs(total);
    if (size == 0.0 || weight == 0.0) return total;
    double force = std::min(
        size, reference_force.si() * std::pow(size / (weight * reference_speed.si()), static_cast<double>(exponent)));
    constexpr int most_iterations = 60;
    for (int i = 0; i < most_iterations; ++i) {
      const double next = force - (force + weight * speed(force) - size) / (1.0 + weight * slope(force));
      const bool settled = !(next < force * (1.0 - 1e-15));
      force = next;
      if (settled) break;
    }
    return std::copysign(force, total);
  }
};

}  // namespace moat
