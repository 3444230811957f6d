// The explicit floor: what this building costs without any library.
#pragma once

#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

struct RungeKuttaSetting {
  int divisions = 1;          ///< >= 1, steps from one sample to the next outside contact
  int steps_per_contact = 8;  ///< >= 1, at least, within the duration of a free elastic impact of the base
};

/// The classical Runge-Kutta method of fourth order for five_storey_equations.hpp. Touches, separations, yields and
/// unloadings are located on the cubic through displacement and velocity and the step is repeated up to there.
Peaks bare_runge_kutta(const GroundMotion& motion, RungeKuttaSetting setting);

}  // namespace moat::performance
