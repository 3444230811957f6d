// The implicit floor: what moat's own method costs for this building without any library.
#pragma once

#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

struct NewmarkSetting {
  double tolerance = 1.2e-4;   ///< as TransientOptions::tolerance
  int steps_per_contact = 32;  ///< as TransientOptions::steps_per_contact
};

/// Average acceleration and Newton's method for five_storey_equations.hpp, with touch and separation located and the
/// step chosen as analyses/step_control.hpp does. The bearing returns to its yield line inside a step.
///
/// Written for speed: the floors are eliminated once per length of step, so that Newton costs one product with a
/// matrix, and a step that stays on one line of the bearing is known to be solved.
Peaks bare_newmark(const GroundMotion& motion, NewmarkSetting setting);

/// The same loop written plainly, step by step alike: in every iteration the 6 x 6 tangent is assembled and factored
/// by Cholesky's method, and the residual tells when a step is solved.
Peaks plain_newmark(const GroundMotion& motion, NewmarkSetting setting);

}  // namespace moat::performance
