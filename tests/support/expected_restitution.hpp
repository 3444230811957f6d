// The restitution that every impact law must deliver: one function per law.
#pragma once

#include <cmath>
#include <numbers>

#include "materials/contact/impact_laws.hpp"
#include "materials/contact/restitution_formulas.hpp"

namespace moat::testing {

// Exact forms of the damping, written from the sources of the laws and not from their headers.

// F = k d^1.5 (1 + z d'/v0).
inline double by_factor(double z) { return restitution_of_viscous_hertz(z); }
// c = 2 xi sqrt(k m) beside a linear spring.
inline double by_ratio(double xi, bool may_pull) {
  return may_pull ? restitution_of_pulling_contact(xi) : restitution_of_clamped_contact(xi);
}
// Returns the restitution of a law that has a constant one.
template <class Law>
double e_of(const Law& law) {
  return law.restitution.value().at(1.0);
}
inline double ratio_of_equation_4(double e) { return -std::log(e) / std::hypot(std::numbers::pi, std::log(e)); }

/// The restitution that a law delivers in a free impact, as an exact function of its parameters, and of mass and speed
/// where it depends on them. The tests of all laws
/// do not compile for a law of AllImpactLaws that has none here.
inline double expected_restitution(const Hertz&) { return 1.0; }
inline double expected_restitution(const HertzDamp& law) {
  return by_factor(3.0 / 4.0 * (1.0 - std::pow(e_of(law), 2)));
}
inline double expected_restitution(const HuntCrossley& law) { return by_factor(3.0 / 2.0 * (1.0 - e_of(law))); }
inline double expected_restitution(const Gonthier& law) {
  return by_factor((1.0 - std::pow(e_of(law), 2)) / e_of(law));
}
inline double expected_restitution(const Ye2009& law) { return by_factor(8.0 * (1.0 - e_of(law)) / (5.0 * e_of(law))); }
inline double expected_restitution(const HuGuo& law) { return by_factor(3.0 * (1.0 - e_of(law)) / (2.0 * e_of(law))); }
inline double expected_restitution(const ExactHertzDamp& law) { return e_of(law); }
inline double expected_restitution(const NonlinearViscoelastic& law) {
  const double e = e_of(law);
  return restitution_of_approach_damping(9.0 * (1.0 - e * e) / (e * (e * (9.0 * std::numbers::pi - 16.0) + 16.0)));
}
inline double expected_restitution(const ModifiedHertzDampPrinted& law) {
  const double x = (1.0 - std::pow(e_of(law), 2)) / (5.0 * std::pow(e_of(law), 2));  // 2 xi/sqrt(5)
  return law.approach_only ? restitution_of_approach_damping(x) : by_ratio(x, law.may_pull);
}
inline double expected_restitution(const LinearElastic&) { return 1.0; }
inline double expected_restitution(const Kelvin& law) { return by_ratio(ratio_of_equation_4(e_of(law)), law.may_pull); }
inline double expected_restitution(const KelvinByDampingRatio& law) {
  return by_ratio(law.damping_ratio, law.may_pull);
}
inline double expected_restitution(const ModifiedLinearViscoelastic& law) {
  const double e = e_of(law);
  return restitution_of_approach_damping((1.0 - e * e) / (e * (e * (std::numbers::pi - 2.0) + 2.0)));
}
inline double expected_restitution(const ExactKelvin& law) { return e_of(law); }
// Loading to d takes m v0^2/2 = K1 d_y^2/2 + K1 d_y (d - d_y) + K2 (d - d_y)^2/2, of which (K1 - K2) d_y (d - d_y) is
// lost.
inline double expected_restitution(const BilinearImpact& law, double mass, double speed) {
  const double dm = law.expected_indentation.si(), a = law.yield_share, e = e_of(law);
  const double lost = law.stiffness.si() * std::pow(dm, 2.5) * (1.0 - e * e) / 2.5;
  const double k1 = law.stiffness.si() * std::sqrt(dm) + lost / (a * dm * dm),
               k2 = law.stiffness.si() * std::sqrt(dm) - lost / ((1.0 - a) * dm * dm), dy = a * dm;
  const double energy = 0.5 * mass * speed * speed, yielding = energy - 0.5 * k1 * dy * dy;
  if (yielding <= 0.0) return 1.0;
  const double beyond = 2.0 * yielding / (k1 * dy + std::sqrt(k1 * k1 * dy * dy + 2.0 * k2 * yielding));
  return std::sqrt(1.0 - (k1 - k2) * dy * beyond / energy);
}

}  // namespace moat::testing
