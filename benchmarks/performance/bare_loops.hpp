// The building without any library of structures: two methods in one loop.
#pragma once

#include "measuring/five_peaks.hpp"
#include "motions/ground_motion.hpp"

namespace moat::performance {

struct BareHistory {
  Peaks peaks{};
  long steps = 0;
  long iterations = 0;  ///< of Newton's method
};

struct RungeKuttaSetting {
  int divisions = 1;          ///< >= 1, steps from one sample to the next outside contact
  int steps_per_contact = 8;  ///< >= 1, at least, within the duration of a free elastic impact of the base
};

/// The explicit floor: the classical Runge-Kutta method of fourth order for five_storey_equations.hpp. Touches,
/// separations, yields and unloadings are located on the cubic through displacement and velocity and the step is
/// repeated up to there.
BareHistory bare_runge_kutta(const GroundMotion& motion, RungeKuttaSetting setting);

/// The implicit floor: Newmark's average acceleration and Newton's method with `divisions` >= 1 steps from one sample
/// to the next, events located in the same way. In every iteration the 6 x 6 tangent is assembled and factored by
/// Cholesky's method.
BareHistory bare_newmark(const GroundMotion& motion, int divisions);

}  // namespace moat::performance
