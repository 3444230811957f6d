// Elastic response spectra.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "base/check.hpp"
#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// Largest responses of damped linear oscillators to one ground motion, one entry per period.
struct ResponseSpectrum {
  double damping_ratio = 0.0;                 ///< Share of critical damping.
  std::vector<double> period;                 ///< T, s
  std::vector<double> displacement;           ///< largest |u| relative to the ground, m
  std::vector<double> pseudo_acceleration;    ///< (2 pi / T)^2 * displacement, m/s^2
  std::vector<double> absolute_acceleration;  ///< largest |u'' + a_g|, m/s^2; damping force included
};

/// The response spectrum of a motion, from oscillators that start at rest:
///
///     u'' + 2 damping_ratio w u' + w^2 u = -a_g(t),   w = 2 pi / T
///
/// Stepped with the exact solution for a ground acceleration that is linear between samples (Nigam and Jennings,
/// Bulletin of the Seismological Society of America 59(2), 1969). A step is at most T/32, so that peaks between samples
/// are found to about 4e-6 of their value. The free vibration after the end of the motion counts.
///
/// periods: each either 0 (a rigid oscillator: both accelerations are the PGA) or from time_step/100 to 1000 s.
/// damping_ratio: >= 0 and < 1. Throws InputError otherwise.
ResponseSpectrum response_spectrum(const GroundMotion& motion, std::span<const Time> periods, double damping_ratio);
/// Throws InputError for a damping ratio outside [0, 1).
void check_damping_ratio(const Check& check, double damping_ratio);
/// Throws InputError for such a damping ratio, and for a period other than 0 s that is not from time_step/100
/// to 1000 s.
void check_oscillators(const Check& check, std::span<const Time> periods, double damping_ratio, double time_step);
/// response_spectrum(motion, {0.5 * s, 1 * s}, 0.05)
inline ResponseSpectrum response_spectrum(const GroundMotion& motion, std::initializer_list<Time> periods,
                                          double damping_ratio) {
  return response_spectrum(motion, std::span<const Time>{periods.begin(), periods.size()}, damping_ratio);
}

}  // namespace moat
