// Linear contact spring with a dashpot beside it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "materials/contact/contact_damping.hpp"
#include "materials/response.hpp"

namespace moat {

/// F = k d + c d' for indentation d > 0, compression positive. Linear elastic, Kelvin and their relatives
/// differ in c and in when it acts; each has a header of its own that makes one of these.
///
/// The contact never pulls unless it separates at_opening. At touch the force jumps to c v0. With damping on approach
/// only, F = k d + c max(d', 0) is continuous where the motion turns and only its slope changes; no instant is located
/// for that. Restitution in terms of x = c/(2 sqrt(k m)): restitution_formulas.hpp.
///
/// While loaded the law continues to d < 0, so that a step that overshoots the separation is still smooth;
/// the separation itself is located. The stored energy is k d^2/2 until the gap opens; a released contact dissipates
/// the rest of it.
struct ViscousLinearContact {
  static constexpr std::string_view name = "ViscousLinearContact";

  double stiffness = 0.0;                             ///< k > 0, N/m
  ContactDamping damping{};                           ///< c >= 0, N s/m
  bool approach_only = false;                         ///< whether the dashpot acts only while the bodies approach
  Separation separation = Separation::at_zero_force;  ///< how contact ends

  using State = ContactState;

  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness, "N/m"},
            {"damping", damping.shown(), "N s/m"},
            {"approach_only", approach_only ? 1.0 : 0.0, "1"},
            {"may_pull", separation == Separation::at_opening ? 1.0 : 0.0, "1"}};
  }

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    trial = committed;
    if (committed.phase != ContactPhase::loaded) return {};
    const double dashpot = acting_damping(committed, rate);
    return {stiffness * indentation + dashpot * rate, stiffness, dashpot};
  }
  double stored_energy(const State& committed, double indentation) const {
    return committed.phase == ContactPhase::open ? 0.0 : 0.5 * stiffness * indentation * indentation;
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    if (committed.phase == ContactPhase::open) return 0.0;
    if (committed.phase == ContactPhase::released) return std::max(-stiffness * indentation * rate, 0.0);
    return acting_damping(committed, rate) * rate * rate;
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

  double regime_margin(const State& committed, double indentation, double rate) const {
    return contact_margin(committed, indentation, push(committed, indentation, rate));
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    return next_contact_state(committed, indentation, rate, damping);
  }
  /// Duration of a free elastic impact, s, pi sqrt(m/k); m is the effective mass. Damping makes a contact longer,
  /// but beyond half of critical the time constant of its dashpot is shorter: then pi m/c.
  double contact_duration(double effective_mass, double approach_speed) const {
    const double elastic = std::numbers::pi * std::sqrt(effective_mass / stiffness), c = damping.at(approach_speed);
    return c * elastic > std::numbers::pi * effective_mass ? std::numbers::pi * effective_mass / c : elastic;
  }

 private:
  // F/k = d + (c/k) d', m.
  [[nodiscard]] double push(const State& committed, double indentation, double rate) const {
    if (approach_only || separation == Separation::at_opening) return std::numeric_limits<double>::infinity();
    return indentation + damping.in(committed) / stiffness * rate;
  }
  [[nodiscard]] double acting_damping(const State& committed, double rate) const {
    return approach_only && rate < 0.0 ? 0.0 : damping.in(committed);
  }
};

}  // namespace moat
