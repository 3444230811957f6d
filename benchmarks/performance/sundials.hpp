// CVODE and ARKODE of SUNDIALS, restarted at every event that their own root finding locates.
#pragma once

#include "performance/sundials_problem.hpp"

namespace moat::performance {

enum class SundialsMethod {
  bdf,                 ///< CVODE: backward differentiation, Newton with the analytic Jacobian and dense factors
  adams,               ///< CVODE: Adams-Moulton with fixed-point iteration, without a Jacobian
  bogacki_shampine_3,  ///< ARKODE, explicit, as are the next two
  zonneveld_4,         ///< the classical method with an error estimate
  dormand_prince_5,
};

/// "Zonneveld"
const char* name_of(SundialsMethod method);

/// Peaks over the whole motion. The error control handles the changes of slope of the ground's acceleration at its
/// samples. Steps are at most twenty intervals, so that no step passes over a motion that begins slowly. Throws Error
/// where SUNDIALS fails.
Peaks sundials_peaks(SundialsProblem& problem, SundialsMethod method, double relative_tolerance);

}  // namespace moat::performance
