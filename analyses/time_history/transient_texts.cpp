#include "analyses/time_history/transient_texts.hpp"

#include <cmath>
#include <optional>
#include <string_view>

#include "base/check.hpp"

namespace moat {
namespace {

std::string_view name_of(EventTreatment events) {
  return events == EventTreatment::located ? "located" : "at_end_of_step";
}

}  // namespace

std::vector<std::string> assumptions_of(const TransientOptions& options, const StepControl& control,
                                        double longest_step) {
  const std::string step = control.adaptive() ? "step adapted to an error of " + to_text(options.tolerance) +
                                                    " of each node's acceleration and to " +
                                                    std::to_string(options.steps_per_contact) +
                                                    " steps per contact, at most " + to_text(longest_step) + " s"
                                              : "fixed step of " + to_text(options.step.si()) + " s";
  std::string method =
      std::visit([](const auto& integrator) { return integrator.description(); }, options.integrator) + ", ";
  if (control.adaptive() && !scheme_of(options.integrator))
    method = std::string{is_exact(options.integrator) ? ExactBetweenEvents{}.description() : "Newmark's method"} +
             ", gamma = 1/2, beta = 1/12 with velocities corrected to fourth order (beta = 1/4 after a touch, and "
             "where a step is too long for that), ";
  return {method + step + "; every step solved until the forces at each node balance to " +
              to_text(options.force_tolerance) + " of the largest force there.",
          options.events == EventTreatment::located
              ? "Touch and separation located until the gap is zero to " + to_text(options.location_tolerance.si()) +
                    " m, acceleration recomputed there."
              : "Touch and separation at the end of the step that crosses them, up to a step too late; acceleration "
                "recomputed there.",
          "Ground acceleration linear between samples and zero after the last one; the system starts at rest at the "
          "first sample unless initial values are given."};
}

AnalysisFacts facts_of(const TransientOptions& options) {
  // An option that is missing here does not compile.
  const auto& [integrator, step, tolerance, steps_per_contact, largest_step, max_halvings, end, force_tolerance,
               max_iterations, line_search, max_cuts, location_tolerance, events, max_events_per_second] = options;
  AnalysisFacts facts{.integrator = std::string{name_of(integrator)},
                      .events = std::string{name_of(events)},
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

std::vector<std::string> warnings_of(const TransientOptions& options, const StepControl& control,
                                     const GroundMotion& motion, const Model& model) {
  constexpr double enough = 32.0;
  const double fewest = control.fewest_steps_per_contact();
  std::vector<std::string> list;
  // The round-off of one step; the steps together excite a vibration that is up to a thousand times as large.
  constexpr double harmful = 1e-6;
  if (control.largest_round_off() > harmful)
    list.push_back("The stiffness at \"" + std::string{model.node_name(control.place_of_round_off())} +
                   "\" is so high that round-off is " + to_text(100.0 * control.largest_round_off()) +
                   " % of the acceleration there in a single step, and up to a thousand times that after many. Check "
                   "the parameters of its elements; a softer spring or a rigid "
                   "connection (one node) gives a sharper answer.");
  if (control.adaptive()) {
    if (fewest < options.steps_per_contact)
      list.push_back("The shortest contact was divided into " + to_text(fewest) + " steps only instead of " +
                     std::to_string(options.steps_per_contact) +
                     ", because the interval of the motion may not be halved more often. " +
                     (options.max_halvings < TransientOptions::most_halvings
                          ? "Raise TransientOptions::max_halvings."
                          : "No setting divides it further: take a softer contact or a heavier body."));
    return list;
  }
  const double step = options.step.si(), interval = motion.time_step();
  const double per_interval = interval / step;
  if (std::abs(per_interval - std::round(per_interval)) > 1e-6 * per_interval || per_interval < 1.0 - 1e-6)
    list.push_back("The fixed step of " + to_text(step) + " s does not divide the motion's interval of " +
                   to_text(interval) + " s: samples between steps are not felt. Take " + to_text(interval) +
                   " s divided by a whole number.");
  const StepScheme scheme = scheme_of(options.integrator).value_or(StepScheme::average_acceleration());
  const double limit = scheme.stability_limit() / std::sqrt(control.stiffest_squared());
  if (step > limit)
    list.push_back("The fixed step is longer than the " + to_text(limit) + " s up to which beta = " +
                   to_text(scheme.beta) + " is sure to be stable. Take a shorter one or average acceleration.");
  if (fewest >= enough) return list;
  list.push_back("The fixed step divides the shortest contact into " + to_text(fewest) +
                 " steps only; with fewer than " + to_text(enough) +
                 " the restitution is off by more than 0.001. Take a step of at most " +
                 to_text(options.step.si() * fewest / enough) + " s, or leave the step out: it adapts itself.");
  return list;
}

}  // namespace moat
