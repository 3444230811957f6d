// ARKODE of SUNDIALS, restarted at every event that its own root finding locates.
#pragma once

#include "measuring/five_peaks.hpp"
#include "motions/ground_motion.hpp"

namespace moat::performance {

/// Explicit Runge-Kutta methods with an error estimate.
enum class SundialsMethod { zonneveld_4, dormand_prince_5 };

/// Peaks of five_storey_equations.hpp over the whole motion. The error control handles the changes of slope of the
/// ground's acceleration at its samples. Steps are at most twenty intervals, so that no step passes over a motion that
/// begins slowly. Throws Error where SUNDIALS fails.
Peaks sundials_peaks(const GroundMotion& motion, SundialsMethod method, double relative_tolerance);

}  // namespace moat::performance
