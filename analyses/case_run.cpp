#include "analyses/case_run.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/periods.hpp"
#include "base/check.hpp"

namespace moat {
namespace {

CaseOptions checked(CaseOptions options) {
  const Check check{"CaseOptions", options.title};
  check.not_negative("history_interval", options.history_interval);
  check.positive("warn_above_energy_error", options.warn_above_energy_error, "1");
  return options;
}

double history_interval(const CaseOptions& options, const GroundMotion& motion) {
  return options.history_interval.si() > 0.0 ? options.history_interval.si() : motion.time_step();
}

// Whether every multiple of the histories' interval is the end of a step.
bool rows_at_steps(double interval, double step) {
  const double ratio = interval / step;
  return std::abs(ratio - std::round(ratio)) < 1e-9 * ratio && ratio > 0.5;
}

}  // namespace

CaseRun::CaseRun(Model& model, const GroundMotion& motion, CaseOptions options)
    : options_{checked(std::move(options))},
      periods_{characteristic_periods(model)},
      transient_{model, motion, options_.transient},
      peaks_{model},
      histories_{model, history_interval(options_, motion), &energy_,
                 !rows_at_steps(history_interval(options_, motion),
                                options_.transient.step.si() > 0.0 ? options_.transient.step.si() : motion.time_step())} {
  attach(energy_);
  attach(peaks_);
  attach(impacts_);
  attach(histories_);
}

CaseResult CaseRun::result() const {
  const GroundMotion& motion = transient_.motion();
  CaseResult result{.title = options_.title,
                    .motion = {.name = motion.name(),
                               .peak_acceleration = motion.peak_acceleration().si(),
                               .peak_velocity = motion.peak_velocity().si(),
                               .time_step = motion.time_step(),
                               .duration = motion.duration()},
                    .periods = periods_,
                    .peaks = peaks_.peaks(),
                    .impacts = impacts_.impacts(),
                    .histories = histories_.table(),
                    .energy = energy_.balance(transient_.model()),
                    .solver = transient_.statistics(),
                    .warnings = transient_.warnings(),
                    .assumptions = transient_.assumptions()};
  const double scale = std::max(result.energy.largest_input, result.energy.largest_kinetic);
  const double error = scale > 0.0 ? std::abs(result.energy.integration_error) / scale : 0.0;
  if (error > options_.warn_above_energy_error)
    result.warnings.push_back("The energy of the elements is off by " + to_text(100.0 * error) +
                              " % of the largest input or kinetic energy, most at \"" + result.energy.worst_element +
                              "\". Take a shorter step or a tighter tolerance.");
  result.assumptions.insert(
      result.assumptions.end(),
      {"Displacements and velocities are relative to the ground, accelerations absolute; positive to the right.",
       "A peak is the largest magnitude over continuous time, also between steps and on both sides of an event.",
       "total_base_shear is the force of isolators and impacts together; sum_of_floor_inertia_maxima adds the "
       "maxima of mass times absolute acceleration of base and floors, which are not simultaneous.",
       "Energies are in the frame of the ground: input is the work of the ground's inertia forces on relative motion.",
       "storey_shear is the elastic force of the columns, without that of the storey's damping."});
  return result;
}

CaseResult run_case(Model& model, const GroundMotion& motion, CaseOptions options) {
  CaseRun run{model, motion, std::move(options)};
  run.run();
  return run.result();
}

}  // namespace moat
