// The five-storey building computed by ARKODE of SUNDIALS.
#pragma once

#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"
#include "performance/sundials_follow.hpp"

namespace moat::performance {

enum class RungeKuttaMethod {
  bogacki_shampine_3,  ///< explicit
  zonneveld_4,         ///< explicit: the classical method with an error estimate
  dormand_prince_5,    ///< explicit
  sdirk_4,             ///< implicit, Newton with the analytic Jacobian and dense factors
};

struct ArkodeSetting {
  RungeKuttaMethod method = RungeKuttaMethod::dormand_prince_5;
  GroundKinks kinks = GroundKinks::stops_at_samples;
  double relative_tolerance = 1e-4;
  /// > 0: no error control, but the interval of the samples divided by this.
  int fixed_divisions = 0;
};

/// Changes of regime by ARKODE's own root finding.
Peaks arkode_peaks(const GroundMotion& motion, const ArkodeSetting& setting);
/// The same with a model of moat in the place of equations written by hand; its yield must be located.
Peaks arkode_peaks(const Model& model, const GroundMotion& motion, const ArkodeSetting& setting);

}  // namespace moat::performance
