#include "analyses/time_history/transient_setup.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace moat {
namespace {

// Whether both motions are the same up to a time, s, at the samples of the finer one.
bool agree_until(double time, const GroundMotion& one, const GroundMotion& other) {
  const double interval = std::min(one.time_step(), other.time_step());
  const double round_off = 1e-9 * one.peak_acceleration().si();
  for (double t = 0.0, i = 0.0; t < time; ++i) {
    t = std::min(i * interval, time);
    // Round-off of the time may put a last sample behind the end of its motion.
    const double before = t * (1.0 - 1e-12);
    if (length(one.components_at(before) - other.components_at(before)) > round_off) return false;
  }
  return true;
}

}  // namespace

double end_of(const TransientOptions& options, const Model& model, const GroundMotion& motion) {
  const Check check{"Transient", motion.name()};
  const double now = model.state().time, end = options.end.si() > 0.0 ? options.end.si() : motion.duration();
  const std::string stands = "the model stands at t = " + to_text(now) + " s";
  const GroundMotion* former = model.state().ground_motion.get();
  check.that(now <= 0.0 || former == nullptr || agree_until(now, *former, motion),
             stands + " under other accelerations of the ground, those of \"" +
                 (former != nullptr ? former->name() : "") + "\".",
             "Copy the model before its first analysis, and give every motion a copy. For shocks one after the other "
             "give one motion, joined({first, second}, 20 * s).");
  check.that(now < end, stands + ", and the analysis ends at " + to_text(end) + " s.",
             "Copy the model before its first analysis to use it again, or give a later TransientOptions::end.");
  return end;
}

StepControl::Options control_options(const TransientOptions& options, const GroundMotion& motion) {
  // Scales of acceleration are at least this share of the peak ground acceleration. A node with a smaller acceleration
  // is at rest, or free.
  constexpr double least_share_of_ground = 0.02;
  StepControl::Options control;
  control.fixed_step = options.step.si();
  control.grid_interval = longest_step(options, motion.time_step());
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
