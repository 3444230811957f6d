// Settings of an analysis that follow from its options, motion and model.
#pragma once

#include "analyses/time_history/step_control.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// The end of the analysis, s: that of the options, else of the motion. Throws InputError where the model stands there
/// already, or came to its time under other accelerations of the ground.
double end_of(const TransientOptions& options, const Model& model, const GroundMotion& motion);

/// Options of the step control.
StepControl::Options control_options(const TransientOptions& options, const GroundMotion& motion);

/// Throws InputError for a motion of two components on a line.
void check_components(const Model& model, const GroundMotion& motion);

}  // namespace moat
