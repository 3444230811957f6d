// Ends a step at a change of regime.
#pragma once

#include "analyses/time_history/step_solver.hpp"

namespace moat {

/// Whether the trial step that was scanned ends just beyond a change, within the location tolerance.
[[nodiscard]] bool is_located(const RegimeScan& seen, double location_tolerance);

/// The trial step of length h crosses a change of regime, found by the scan `seen`. Re-solves with shorter steps until
/// one ends just beyond the first change, and returns its length: regula falsi on the margin at the end of the step,
/// halved where it is slow. Interpolation of the state instead of a new solution would cause an error of energy.
///
/// If such a step must be cut because Newton fails, the result may end before the change; the next step then finds it.
double locate_change(StepSolver& step, double h, RegimeScan seen);

}  // namespace moat
