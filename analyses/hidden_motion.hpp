// Motion of the ground that a step over several samples would hide.
#pragma once

#include "analyses/step_grid.hpp"
#include "analyses/step_solver.hpp"

namespace moat {

/// Whether the ground moves so much inside the trial step of length h that an element near its margin, or a peak, would
/// be missed: both are looked for on smooth paths between the ends of the step. `margin` is that at the start of the
/// step, m.
[[nodiscard]] bool hides_motion(const StepSolver& step, const StepGrid& grid, double h, double margin);

}  // namespace moat
