// The five-storey building computed by CVODE of SUNDIALS.
#pragma once

#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"
#include "performance/sundials_follow.hpp"

namespace moat::performance {

enum class Multistep {
  bdf,                ///< backward differentiation, Newton with the analytic Jacobian and dense factors
  adams_fixed_point,  ///< Adams-Moulton, for problems that are not stiff, without a Jacobian
};

struct CvodeSetting {
  Multistep method = Multistep::bdf;
  GroundKinks kinks = GroundKinks::steps_at_most_the_interval;
  double relative_tolerance = 1e-4;
};

/// Changes of regime by CVODE's own root finding.
Peaks cvode_peaks(const GroundMotion& motion, const CvodeSetting& setting);
/// The same with a model of moat in the place of equations written by hand; its yield must be located.
Peaks cvode_peaks(const Model& model, const GroundMotion& motion, const CvodeSetting& setting);

}  // namespace moat::performance
