#include "analyses/transient_setup.hpp"

#include "base/check.hpp"

namespace moat {

double end_of(const TransientOptions& options, const Model& model, const GroundMotion& motion) {
  const double end = options.end.si() > 0.0 ? options.end.si() : motion.duration();
  Check{"Transient", motion.name()}.that(
      model.state().time < end,
      "the model stands at t = " + to_text(model.state().time) + " s, and the analysis ends at " + to_text(end) + " s.",
      "Copy the model before its first analysis to use it again, or give a later TransientOptions::end.");
  return end;
}

StepControl::Options control_options(const TransientOptions& options, const Model& model, const GroundMotion& motion) {
  // Scales of acceleration are at least this share of the peak ground acceleration. A node with a smaller acceleration
  // is at rest, or free.
  constexpr double least_share_of_ground = 0.02;
  StepControl::Options control;
  control.fixed_step = options.step.si();
  control.grid_interval = longest_step(options, motion.time_step());
  // In plan no step is longer than the interval of the samples.
  control.doublings = model.is_plan() ? 0 : doublings_of_longest_step(options, motion.time_step());
  control.tolerance = options.tolerance;
  control.steps_per_contact = options.steps_per_contact;
  control.max_halvings = options.max_halvings;
  control.scheme = scheme_of(options.integrator);
  control.lowest_acceleration = least_share_of_ground * motion.peak_acceleration().si();
  return control;
}

void check_components(const Model& model, const GroundMotion& motion) {
  Check{"Transient", motion.name()}.that(model.is_plan() || !motion.has_two_components(),
                                         "the motion has two components, and the model moves on a line.",
                                         "Give one component, or make the model of diaphragms.");
}

}  // namespace moat
