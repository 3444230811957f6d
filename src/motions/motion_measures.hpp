// Measures of a ground motion: intensity, duration, period of its pulse.
#pragma once

#include <vector>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {

/// Two instants of a motion.
struct MotionInterval {
  double start = 0.0;  ///< s
  double end = 0.0;    ///< s, >= start

  /// s
  [[nodiscard]] double length() const { return end - start; }
};

/// Arias intensity, m/s (Arias (1970), A measure of earthquake intensity; in: Seismic Design for Nuclear Power Plants),
///
///     I = pi / (2 g) * integral of a_g(t)^2 dt,   g = 9.80665 m/s^2
///
/// over the whole motion, exact for accelerations that are linear between samples. Throws InputError for a motion of
/// two components.
Speed arias_intensity(const GroundMotion& motion);

/// The time between two shares of the Arias intensity (Trifunac & Brady (1975), Bulletin of the Seismological Society
/// of America 65(3)): from the instant at which the integral has reached `from` of its end value to that of `to`.
///
/// 0 <= from < to <= 1. Throws InputError for other shares, for two components, and for a motion that is zero.
MotionInterval significant_duration(const GroundMotion& motion, double from = 0.05, double to = 0.95);

/// Logarithmically spaced periods, both ends included. first: > 0 s; last: > first; count >= 2. Throws InputError.
std::vector<Time> spaced_periods(Time first, Time last, int count);

/// Pulse period: that of the largest pseudo-velocity, PSV = T / (2 pi) * PSA, of a response spectrum with 5 % damping
/// (Alavi & Krawinkler (2001), Effects of near-fault ground motions on frame structures, Blume Center Report 138), s.
/// Among 400 periods from 0.1 to 20 s; for a motion with a pulse only, since every motion has a largest value.
/// Throws InputError for two components.
Time pulse_period(const GroundMotion& motion);

/// The pseudo-velocities of a spectrum, PSV = T / (2 pi) * PSA, m/s.
std::vector<double> pseudo_velocity(const ResponseSpectrum& spectrum);

}  // namespace moat
