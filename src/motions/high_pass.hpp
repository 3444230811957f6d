// Removing long periods from a record.
#pragma once

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// The motion after a causal Butterworth high-pass filter, as data centres apply it against drift of the baseline.
///
/// The analogue filter |H(f)|^2 = 1/(1 + (corner/f)^(2 order)) is made digital by the bilinear transform with the
/// corner kept in place, so that at a time step h
///
///     |H(f)|^2 = 1/(1 + (tan(pi corner h)/tan(pi f h))^(2 order))
///
/// and runs once, forward, from rest, in sections of second order (one of first order if the order is odd). Being
/// causal it delays long periods; PGA, PGV and the first sample change. A note says that it was applied.
///
/// corner: > 0 Hz and < 1/(2 time step). order: 1 to 20. Throws InputError otherwise.
GroundMotion high_passed(const GroundMotion& motion, Frequency corner, int order);

}  // namespace moat
