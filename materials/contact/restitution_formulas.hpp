// Exact formulas for the restitution of a contact in free impact, and for the damping that a restitution needs.
#pragma once

namespace moat {

// Linear spring k and dashpot c between two bodies of effective mass m; x = c / (2 sqrt(k m)) is the damping
// ratio. With a = acos x, continued by a = i acosh x beyond critical damping, a cot a is real for every x >= 0.

/// The dashpot acts until the gap opens, pulling before: e = exp(-pi x/sqrt(1 - x^2)). 0 <= x < 1; beyond, the
/// contact never ends and this returns 0.
double restitution_of_pulling_contact(double damping_ratio);
/// The dashpot acts until the force reaches zero: e = exp(-2 a cot a). x >= 0; critical damping gives exp(-2).
double restitution_of_clamped_contact(double damping_ratio);
/// The dashpot acts on approach only: e = exp(-a cot a). x >= 0.
double restitution_of_approach_damping(double damping_ratio);

/// Inverse of restitution_of_pulling_contact: x = -ln e/sqrt(pi^2 + ln^2 e) for 0 < e <= 1; paper Eq. 4.
double damping_ratio_of_pulling_contact(double restitution);
/// Inverse of restitution_of_clamped_contact for 0 < e <= 1; x > 1 for e < exp(-2) = 0.1353.
double damping_ratio_of_clamped_contact(double restitution);

// Hertz contact F = k d^1.5 (1 + z d'/v0).

/// e of ln((1 + z)/(1 - z e)) = z (1 + e) for z >= 0.
double restitution_of_viscous_hertz(double damping_factor);
/// z of the same equation for 0 < e <= 1; between 0 and 1/e.
double damping_factor_of_viscous_hertz(double restitution);
/// Duration of a free elastic impact, z = 0, at v0 (m/s) of two bodies of effective mass m (kg), s:
/// 2.94328 (5 m v0^2/(4 k))^0.4 / v0.
double elastic_hertz_duration(double stiffness, double effective_mass, double approach_speed);

}  // namespace moat
