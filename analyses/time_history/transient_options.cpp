#include "analyses/time_history/transient_options.hpp"

#include <algorithm>

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
  check.between("max_halvings", options.max_halvings, 0, StepSettings::most_halvings, "1");
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
  if (options.step.si() > 0.0) return options.step.si();
  double step = sample_interval;
  if (options.largest_step.si() <= 0.0) return step;
  // Half of a step that was given as a power of two must not be missed by round-off.
  for (int halvings = 0; halvings < StepSettings::most_halvings && step > options.largest_step.si() * (1.0 + 1e-9);
       ++halvings)
    step *= 0.5;
  return step;
}

StepSettings settings_of(const TransientOptions& options, const GroundMotion& motion) {
  return {.fixed_step = options.step.si(),
          .longest_step = longest_step(options, motion.time_step()),
          .sample_interval = motion.time_step(),
          .peak_ground_acceleration = motion.peak_acceleration().si(),
          .tolerance = options.tolerance,
          .steps_per_contact = options.steps_per_contact,
          .max_halvings = options.max_halvings,
          .newton = {.tolerance = options.force_tolerance,
                     .max_iterations = options.max_iterations,
                     .line_search = options.line_search},
          .max_cuts = options.max_cuts,
          .location_tolerance = options.location_tolerance.si()};
}

AnalysisFacts facts_of(const TransientOptions& options) {
  // An option that is missing here does not compile.
  const auto& [integrator, step, tolerance, steps_per_contact, largest_step, max_halvings, end, force_tolerance,
               max_iterations, line_search, max_cuts, location_tolerance, events, max_events_per_second] = options;
  AnalysisFacts facts{.integrator = std::string{name_of(integrator)},
                      .events = events == EventTreatment::located ? "located" : "at_end_of_step",
                      .options = {{"step", step.si(), "s"},
                                  {"tolerance", tolerance, "1"},
                                  {"steps_per_contact", static_cast<double>(steps_per_contact), "1"},
                                  {"largest_step", largest_step.si(), "s"},
                                  {"max_halvings", static_cast<double>(max_halvings), "1"},
                                  {"end", end.si(), "s"},
                                  {"force_tolerance", force_tolerance, "1"},
                                  {"max_iterations", static_cast<double>(max_iterations), "1"},
                                  {"backtracks_always", line_search == LineSearch::backtrack ? 1.0 : 0.0, "1"},
                                  {"max_cuts", static_cast<double>(max_cuts), "1"},
                                  {"location_tolerance", location_tolerance.si(), "m"},
                                  {"max_events_per_second", static_cast<double>(max_events_per_second), "1"}}};
  // Without a scheme the analysis chooses one for every step.
  if (const std::optional<StepScheme> scheme = scheme_of(integrator)) {
    facts.integrator = std::visit([](const auto& each) { return each.description(); }, integrator);
    facts.options.insert(facts.options.end(), {{"beta", scheme->beta, "1"},
                                               {"gamma", scheme->gamma, "1"},
                                               {"mass_share", scheme->mass_share, "1"},
                                               {"force_share", scheme->force_share, "1"},
                                               {"corrects_velocity", scheme->corrects_velocity ? 1.0 : 0.0, "1"}});
  }
  return facts;
}

}  // namespace moat
