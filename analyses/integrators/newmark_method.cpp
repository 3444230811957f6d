#include "analyses/integrators/newmark_method.hpp"

#include <cmath>
#include <utility>

#include "analyses/integrators/newmark.hpp"
#include "base/check.hpp"

namespace moat {

NewmarkMethod::NewmarkMethod(AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme,
                             std::string description)
    : state_{&state},
      settings_{settings},
      scheme_of_all_{scheme},
      description_{std::move(description)},
      equations_{state},
      newton_{equations_, settings.newton},
      control_{state, settings, scheme} {
  acceleration_.setZero(state.model().degrees_of_freedom());
}

double NewmarkMethod::propose() {
  const StepControl::Step step = control_.next_step(*state_);
  scheme_ = step.scheme;
  return step.length;
}

bool NewmarkMethod::solve(const StepTask& task) {
  equations_.begin(task, scheme_, acceleration_);
  last_report_ = newton_.solve(acceleration_);
  newton_iterations_ += last_report_.iterations;
  if (last_report_.converged) equations_.complete();
  return last_report_.converged;
}

void NewmarkMethod::restart(bool touched) {
  equations_.forget();
  control_.restart(*state_, touched);
}

void NewmarkMethod::add_costs(SolverStatistics& statistics) const {
  statistics.newton_iterations += newton_iterations_;
  statistics.factorisations += equations_.factorisations();
}

std::string NewmarkMethod::description() const {
  const std::string step =
      control_.adaptive() ? "step adapted to an error of " + to_text(settings_.tolerance) +
                                " of each node's acceleration and to " + std::to_string(settings_.steps_per_contact) +
                                " steps per contact, at most " + to_text(settings_.longest_step) + " s"
                          : "fixed step of " + to_text(settings_.fixed_step) + " s";
  const std::string method =
      scheme_of_all_ ? description_
      : control_.adaptive()
          ? "Newmark's method, gamma = 1/2, beta = 1/12 with velocities corrected to fourth order (beta = 1/4 after a "
            "touch, and where a step is too long for that)"
          : Newmark{}.description();
  return method + ", " + step + "; every step solved until the forces at each node balance to " +
         to_text(settings_.newton.tolerance) + " of the largest force there";
}

std::vector<std::string> NewmarkMethod::warnings() const {
  std::vector<std::string> list;
  // The round-off of one step; the steps together excite a vibration that is up to a thousand times as large. Trial:
  // among links of 1e8 to 1e11 times the stiffness this finds all that are off by 0.1 % (RigidLink.IsRightOrWarns).
  constexpr double harmful = 1e-6;
  if (control_.largest_round_off() > harmful)
    list.push_back("The stiffness at \"" + std::string{state_->model().node_name(control_.place_of_round_off())} +
                   "\" is so high that round-off is " + to_text(100.0 * control_.largest_round_off()) +
                   " % of the acceleration there in a single step, and up to a thousand times that after many. Check "
                   "the parameters of its elements; a softer spring or a rigid "
                   "connection (one node) gives a sharper answer.");
  if (!control_.adaptive()) {
    for (std::string& warning : warnings_of_fixed_step()) list.push_back(std::move(warning));
  } else if (const double fewest = control_.fewest_steps_per_contact(); fewest < settings_.steps_per_contact) {
    list.push_back("The shortest contact was divided into " + to_text(fewest) + " steps only instead of " +
                   std::to_string(settings_.steps_per_contact) +
                   ", because the interval of the motion may not be halved more often. " +
                   (settings_.max_halvings < StepSettings::most_halvings
                        ? "Raise TransientOptions::max_halvings."
                        : "No setting divides it further: take a softer contact or a heavier body."));
  }
  return list;
}

std::vector<std::string> NewmarkMethod::warnings_of_fixed_step() const {
  constexpr int enough = StepSettings{}.steps_per_contact;
  const double step = settings_.fixed_step, interval = settings_.sample_interval, per_interval = interval / step;
  std::vector<std::string> list;
  if (std::abs(per_interval - std::round(per_interval)) > 1e-6 * per_interval)
    list.push_back("The fixed step of " + to_text(step) + " s does not divide the motion's interval of " +
                   to_text(interval) + " s: samples between steps are not felt. Take " + to_text(interval) +
                   " s divided by a whole number.");
  const StepScheme scheme = scheme_of_all_.value_or(StepScheme::average_acceleration());
  const double limit = scheme.stability_limit() / std::sqrt(control_.stiffest_squared());
  if (step > limit)
    list.push_back("The fixed step is longer than the " + to_text(limit) + " s up to which beta = " +
                   to_text(scheme.beta) + " is sure to be stable. Take a shorter one or average acceleration.");
  if (const double fewest = control_.fewest_steps_per_contact(); fewest < enough)
    list.push_back("The fixed step divides the shortest contact into " + to_text(fewest) +
                   " steps only; with fewer than " + to_text(enough) +
                   " the restitution is off by more than 0.001. Take a step of at most " +
                   to_text(step * fewest / enough) + " s, or leave the step out: it adapts itself.");
  return list;
}

StepMethods newmark_alone(AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme,
                          std::string description) {
  StepMethods methods;
  methods.by_preference.push_back(std::make_unique<NewmarkMethod>(state, settings, scheme, std::move(description)));
  return methods;
}

}  // namespace moat
