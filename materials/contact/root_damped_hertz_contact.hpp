// Hertz contact whose damping grows with the fourth root of the indentation.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "materials/contact/contact_damping.hpp"
#include "materials/contact/restitution_formulas.hpp"
#include "materials/response.hpp"

namespace moat {

/// F = k d^1.5 + c d^0.25 d' for indentation d > 0, compression positive; c = 2 xi sqrt(k m) with the
/// effective mass m (Jankowski 2006). The dashpot may act on approach only.
///
/// The contact never pulls unless it separates at_opening. In terms of y = d^1.25 a free impact is that of a linear
/// spring and dashpot with the damping ratio x = 2 xi / sqrt(5): the formulas of restitution_formulas.hpp are exact for
/// any k, m and approach speed.
///
/// The slope of d^0.25 is infinite at d = 0. Below `least_root_indentation`, a thousandth of the location tolerance of
/// a touch, the fourth root is replaced by a straight line, so that Newton's method sees finite tangents. With damping
/// on approach only the force is continuous where the motion turns and only its slope changes; no instant is located
/// for that.
///
/// The stored energy is 0.4 k d^2.5 until the gap opens; a released contact dissipates the rest of it.
struct RootDampedHertzContact {
  static constexpr std::string_view name = "RootDampedHertzContact";

  double stiffness = 0.0;                             ///< k > 0, N/m^1.5
  ContactDamping damping{};                           ///< c >= 0, N s/m^1.25
  bool approach_only = false;                         ///< whether the dashpot acts only while the bodies approach
  Separation separation = Separation::at_zero_force;  ///< how contact ends

  using State = ContactState;

  /// m
  static constexpr double least_root_indentation = 1e-15;

  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness, "N/m^1.5"},
            {"damping", damping.shown(), "N s/m^1.25"},
            {"approach_only", approach_only ? 1.0 : 0.0, "1"},
            {"may_pull", separation == Separation::at_opening ? 1.0 : 0.0, "1"}};
  }

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    trial = committed;
    if (committed.phase != ContactPhase::loaded || indentation <= 0.0) return {};
    const double root = std::sqrt(indentation);
    const FourthRoot fourth = fourth_root(indentation);
    const double dashpot = acting_damping(committed, rate);
    return {stiffness * indentation * root + dashpot * fourth.value * rate,
            1.5 * stiffness * root + dashpot * fourth.slope * rate, dashpot * fourth.value};
  }
  double stored_energy(const State& committed, double indentation) const {
    if (committed.phase == ContactPhase::open || indentation <= 0.0) return 0.0;
    return 0.4 * stiffness * indentation * indentation * std::sqrt(indentation);
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    if (committed.phase == ContactPhase::open || indentation <= 0.0) return 0.0;
    if (committed.phase == ContactPhase::released)
      return std::max(-stiffness * indentation * std::sqrt(indentation) * rate, 0.0);
    return acting_damping(committed, rate) * fourth_root(indentation).value * rate * rate;
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

  double regime_margin(const State& committed, double indentation, double rate) const {
    return contact_margin(committed, indentation, push(committed, indentation, rate));
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    return next_contact_state(committed, indentation, rate, damping);
  }
  /// Duration of a free elastic impact, s, 2.94328 (5 m v0^2/(4 k))^0.4 / v0; m is the effective mass. Damping
  /// makes a contact longer, but beyond half of critical (2 x > 1) the time constant of its dashpot is shorter: then
  /// 1/(2 x) of that.
  double contact_duration(double effective_mass, double approach_speed) const {
    const double twice_ratio = 2.0 * damping.at(approach_speed) / std::sqrt(5.0 * stiffness * effective_mass);
    return elastic_hertz_duration(stiffness, effective_mass, approach_speed) / std::max(twice_ratio, 1.0);
  }

 private:
  struct FourthRoot {
    double value, slope;
  };
  static FourthRoot fourth_root(double indentation) {
    if (indentation < least_root_indentation) {
      const double slope = std::pow(least_root_indentation, -0.75);
      return {indentation * slope, slope};
    }
    const double value = std::sqrt(std::sqrt(indentation));
    return {value, 0.25 * value / indentation};
  }
  [[nodiscard]] double acting_damping(const State& committed, double rate) const {
    return approach_only && rate < 0.0 ? 0.0 : damping.in(committed);
  }
  // The force over k d^0.25, so that it crosses zero with a finite slope, and over L^0.25 with L = (c v0/k)^0.8, the
  // depth at which the dashpot at v0 pushes as hard as the spring: m.
  [[nodiscard]] double push(const State& committed, double indentation, double rate) const {
    const double c = damping.in(committed);
    if (approach_only || separation == Separation::at_opening || c == 0.0 || committed.phase == ContactPhase::open)
      return std::numeric_limits<double>::infinity();
    const double depth = std::max(indentation, 0.0);
    const double elastic = depth > 0.0 ? depth * std::sqrt(depth) / fourth_root(depth).value : 0.0;
    const double by_rate = c / stiffness;
    return (elastic + by_rate * rate) / std::pow(by_rate * committed.approach_speed, 0.2);
  }
};

}  // namespace moat
