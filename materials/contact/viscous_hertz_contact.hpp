// Hertz contact with damping in proportion to the elastic force.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "materials/contact/contact_damping.hpp"
#include "materials/contact/restitution_formulas.hpp"
#include "materials/response.hpp"

namespace moat {

/// F = k d^1.5 (1 + z d'/v0) for indentation d > 0, compression positive; v0 is the approach speed at
/// first touch, and 1e-4 m/s (least_approach_speed) for slower ones. A whole family of impact laws has this form; they
/// differ in how z follows from the coefficient of restitution: ViscousHertzLaw makes one of these from such a factor.
///
/// The contact never pulls unless it separates at_opening: it ends where the force reaches zero, that is where
/// d' = -v0/z, or where the gap opens. A free impact of two bodies always ends with the gap opening, at a
/// restitution e that satisfies ln((1 + z)/(1 - z e)) = z (1 + e), for any k, masses and speed from 1e-4 m/s up: there
/// Separation changes nothing. An impact at a lower speed v is that of the factor z v/1e-4 m/s. Separation matters only
/// where bodies are drawn apart faster than v0/z.
///
/// The stored energy is 0.4 k d^2.5 until the gap opens; a released contact dissipates the rest of it.
struct ViscousHertzContact {
  static constexpr std::string_view name = "ViscousHertzContact";

  double stiffness = 0.0;                             ///< k > 0, N/m^1.5
  ContactDamping damping_factor{};                    ///< z >= 0, dimensionless
  Separation separation = Separation::at_zero_force;  ///< how contact ends

  using State = ContactState;

  /// |d'/v0| is limited to this. Without the limit a very small v0 makes the damping force arbitrarily large.
  static constexpr double largest_speed_ratio = 100.0;

  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness, "N/m^1.5"},
            {"damping_factor", damping_factor.shown(), "1"},
            {"may_pull", separation == Separation::at_opening ? 1.0 : 0.0, "1"}};
  }

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    trial = committed;
    if (committed.phase != ContactPhase::loaded || indentation <= 0.0) return {};
    const double root = std::sqrt(indentation);
    const double elastic = stiffness * indentation * root;
    const double ratio = speed_ratio(committed, rate);
    const double z = damping_factor.in(committed), factor = 1.0 + z * ratio;
    return {elastic * factor, 1.5 * stiffness * root * factor,
            std::abs(ratio) < largest_speed_ratio ? elastic * z / committed.approach_speed : 0.0};
  }
  double stored_energy(const State& committed, double indentation) const {
    if (committed.phase == ContactPhase::open || indentation <= 0.0) return 0.0;
    return 0.4 * stiffness * indentation * indentation * std::sqrt(indentation);
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    if (committed.phase == ContactPhase::open || indentation <= 0.0) return 0.0;
    const double elastic = stiffness * indentation * std::sqrt(indentation);
    if (committed.phase == ContactPhase::released) return std::max(-elastic * rate, 0.0);
    return elastic * damping_factor.in(committed)*speed_ratio(committed, rate) * rate;
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

  double regime_margin(const State& committed, double indentation, double rate) const {
    return contact_margin(committed, indentation, push(committed, indentation, rate));
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    return next_contact_state(committed, indentation, rate, damping_factor);
  }
  /// Duration of a free elastic impact, s, 2.94328 (5 m v0^2/(4 k))^0.4 / v0; m is the effective mass. Damping
  /// makes a contact longer.
  double contact_duration(double effective_mass, double approach_speed) const {
    return elastic_hertz_duration(stiffness, effective_mass, approach_speed);
  }

 private:
  // F/(k sqrt(d)) = d (1 + z d'/v0), m.
  [[nodiscard]] double push(const State& committed, double indentation, double rate) const {
    if (separation == Separation::at_opening || committed.phase == ContactPhase::open)
      return std::numeric_limits<double>::infinity();
    return std::max(indentation, 0.0) * (1.0 + damping_factor.in(committed)*speed_ratio(committed, rate));
  }
  static double speed_ratio(const State& committed, double rate) {
    return std::clamp(rate / committed.approach_speed, -largest_speed_ratio, largest_speed_ratio);
  }
};

}  // namespace moat
