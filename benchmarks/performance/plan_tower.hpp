// A tower of two floors in plan, in a moat, as moat and as a loop written for it.
#pragma once

#include <moat.hpp>

namespace moat::performance {

/// The tower of tests/analyses/plan_reference_test.cpp: base of 800 t and floor of 700 t, 20 x 12 m, the floor's centre
/// of mass at (1.0, 0.6) m; four columns, four Bouc-Wen bearings, walls at 25 cm with friction 0.2.
Model plan_tower();
/// Two near-fault pulses of 0.40 g and 0.25 g.
GroundMotion plan_tower_motion();

struct BarePlanHistory {
  double largest_base_x = 0.0;  ///< m, at ends of steps
  long steps = 0, iterations = 0;
};

inline constexpr double bare_plan_end = 12.0;  // s

/// The same tower without any library of structures: Newmark's average acceleration and Newton's method with a dense
/// 6 x 6 matrix, `divisions` >= 1 steps from one sample to the next, up to bare_plan_end. Touches are not located: a
/// contact begins at the end of the step in which its corner crosses the wall.
BarePlanHistory bare_plan_tower(const GroundMotion& motion, int divisions);

}  // namespace moat::performance
