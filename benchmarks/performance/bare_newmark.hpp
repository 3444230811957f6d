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
Peaks bare_newmark(const GroundMotion& motion, NewmarkSetting setting);

}  // namespace moat::performance
