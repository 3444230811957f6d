// A synthetic near-fault velocity pulse.
#pragma once

#include <numbers>

#include "base/quantity.hpp"
#include "base/units.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Parameters of the pulse of Mavroeidis and Papageorgiou (Bulletin of the Seismological Society of America 93(3),
/// 2003): a cosine under a raised-cosine bell. With f = 1 / pulse_period and the time t counted
/// from the middle of the pulse, the ground velocity is
///
///     v(t) = amplitude / 2 * [1 + cos(2 pi f t / oscillation_ratio)] * cos(2 pi f t + phase)
///
/// for |t| <= oscillation_ratio * pulse_period / 2 and zero elsewhere. Velocity and acceleration vanish at both ends
/// for every phase, so that the ground starts from rest and comes to rest. It also returns to where it was if
/// oscillation_ratio is a whole number or phase is pi/2; otherwise it stays displaced.
///
/// The defaults give PGA = 0.385 g, PGV = 77 cm/s, PGV/PGA = 0.205 s (in the range of the near-fault records with which
/// isolated buildings in moats have been studied), no permanent displacement, and 16 s to come to rest in 20 s.
struct NearFaultPulse {
  Time pulse_period = 1.3 * units::s;             ///< > 0 s; period of the cosine
  Speed amplitude = 0.8 * (units::m / units::s);  ///< > 0 m/s; PGV if phase = 0, otherwise somewhat above it
  double oscillation_ratio = 2.0;                 ///< > 1 and <= 20; the paper's gamma: pulse length / pulse_period
  double phase = std::numbers::pi / 4;            ///< from -2 pi to 2 pi, rad; the paper's nu
  Time time_step = 0.005 * units::s;              ///< > 0 s and <= pulse_period / 20
  Time lead_in = 1.4 * units::s;                  ///< from 0 s to 1000 s; rest before the pulse
  Time quiet_after = 16.0 * units::s;             ///< from 0 s to 1000 s; rest after it, to see rebounds
};

/// The pulse, sampled from time 0 to at least the end of quiet_after; the first sample is exactly zero.
///
///     const GroundMotion motion = near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g);
///
/// Sampling changes velocity and displacement by errors of second order in the time step. The ground velocity left
/// after the pulse is zero to round-off for any time step, if oscillation_ratio is a whole number and the pulse starts
/// and ends on samples, as with the defaults; otherwise it is such an error too. Throws InputError naming the parameter
/// that is out of range, or if there would be more than ten million samples.
GroundMotion near_fault_pulse(const NearFaultPulse& parameters = {});

}  // namespace moat
