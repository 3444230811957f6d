#include "analyses/time_history/transient_options.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace moat {

const TransientOptions& checked(const TransientOptions& options, const GroundMotion& motion) {
  const Check check{"TransientOptions", ""};
  std::visit([&](const auto& integrator) { integrator.check(check); }, options.integrator);
  check.not_negative("step", options.step);
  check.that(!is_exact(options.integrator) || options.step.si() == 0.0, "step", options.step.si(), "s",
             "0 s with ExactBetweenEvents{}", "Its steps adapt themselves.");
  check.that(options.tolerance >= TransientOptions::least_tolerance && options.tolerance < 1.0, "tolerance",
             options.tolerance, "1", ">= 1e-12 and < 1",
             to_text(TransientOptions{}.tolerance) + " is the default; below 1e-12 is round-off.");
  check.that(options.steps_per_contact >= 4, "steps_per_contact", options.steps_per_contact, "1", ">= 4");
  check.not_negative("largest_step", options.largest_step);
  check.between("max_halvings", options.max_halvings, 0, TransientOptions::most_halvings, "1");
  check.not_negative("end", options.end);
  check.that(options.force_tolerance > 0.0 && options.force_tolerance < 1.0, "force_tolerance", options.force_tolerance,
             "1", "> 0 and < 1");
  check.that(options.max_iterations >= 1, "max_iterations", options.max_iterations, "1", ">= 1");
  check.that(options.max_cuts >= 0, "max_cuts", options.max_cuts, "1", ">= 0");
  check.positive("location_tolerance", options.location_tolerance);
  check.that(options.max_events_per_second >= 1, "max_events_per_second", options.max_events_per_second, "1", ">= 1");
  constexpr double most_steps = 1e9;  // about a day of computing; more is a mistake in the input
  const double end = options.end.si() > 0.0 ? options.end.si() : motion.duration();
  const double step = options.step.si() > 0.0 ? std::min(options.step.si(), motion.time_step()) : motion.time_step();
  check.that(end / step <= most_steps, "number of steps (end / step)", end / step, "1", "<= 1e9",
             "Take a longer step (now " + to_text(step) + " s) or an earlier end (now " + to_text(end) + " s).");
  return options;
}

double longest_step(const TransientOptions& options, double sample_interval) {
  constexpr int most_halvings = 40;
  if (options.step.si() > 0.0) return options.step.si();
  double step = sample_interval;
  if (options.largest_step.si() <= 0.0) return step;
  // Half of a step that was given as a power of two must not be missed by round-off.
  for (int halvings = 0; halvings < most_halvings && step > options.largest_step.si() * (1.0 + 1e-9); ++halvings)
    step *= 0.5;
  return step;
}

}  // namespace moat
