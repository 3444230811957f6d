// A law replayed in free flight.
#pragma once

#include <functional>

#include "materials/contact/contact_state.hpp"
#include "materials/response.hpp"

namespace moat {

/// The free impact of two bodies: m d'' = -F(d, d') from d = 0, d' = v0.
struct FreeImpact {
  std::function<double(double indentation, double rate)> force;   ///< N
  std::function<double(double indentation, double rate)> margin;  ///< m, negative where the regime has ended
  /// Enters the next regime there; whether the contact goes on.
  std::function<bool(double indentation, double rate)> goes_on;
  double effective_mass = 0.0;  ///< m > 0 kg
  double approach_speed = 0.0;  ///< v0 > 0 m/s
  double duration = 0.0;        ///< > 0 s, a time scale of the contact
};

/// The restitution e = -d'/v0 at the end of the contact. The error is below 1e-9: Dormand and Prince's method with
/// adapted steps, the end located. Throws Error if the contact has not ended after 1e5 steps.
double delivered_restitution(const FreeImpact& impact);

/// The restitution that a law delivers in the free impact of two bodies, which fly on where the contact ends.
///
/// effective_mass m = m1 m2/(m1 + m2) > 0 kg, approach_speed v0 > 0 m/s; below least_approach_speed laws with d'/v0
/// divide by that floor here too. Throws Error if the contact has not ended after 1e5 steps.
template <ContactLaw Law>
double delivered_restitution(const Law& law, double effective_mass, double approach_speed) {
  typename Law::State contact = law.next_regime({}, 0.0, approach_speed);
  return delivered_restitution(FreeImpact{
      .force =
          [&](double indentation, double rate) {
            typename Law::State trial;
            return law.evaluate(contact, indentation, rate, trial).force;
          },
      .margin = [&](double indentation, double rate) { return law.regime_margin(contact, indentation, rate); },
      .goes_on =
          [&](double indentation, double rate) {
            contact = law.next_regime(contact, indentation, rate);
            return contact.phase == ContactPhase::loaded;
          },
      .effective_mass = effective_mass,
      .approach_speed = approach_speed,
      .duration = law.contact_duration(effective_mass, approach_speed)});
}

}  // namespace moat
