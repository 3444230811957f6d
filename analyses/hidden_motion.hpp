// Motion of the ground that a step over several samples would hide.
#pragma once

#include "analyses/step_equations.hpp"
#include "model/model.hpp"

namespace moat {

/// Whether the ground moves so much inside the step to the trial state that an element near its margin, or a peak,
/// would be missed: both are looked for on smooth paths between the ends of the step. `margin` is the smaller one of
/// those at both ends, m.
[[nodiscard]] bool hides_motion(const Model& model, const StepTask& step, double margin);

}  // namespace moat
