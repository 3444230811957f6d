#include "analyses/time_history/transient.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <utility>

#include "analyses/events/event_location.hpp"
#include "analyses/integrators/integrator_choice.hpp"
#include "analyses/time_history/model_checks.hpp"
#include "analyses/time_history/transient_setup.hpp"
#include "analyses/time_history/transient_texts.hpp"
#include "base/error.hpp"

namespace moat {
namespace {

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

Transient::Transient(Model& model, GroundMotion motion, TransientOptions options)
    : model_{&model},
      motion_{std::make_shared<const GroundMotion>(std::move(motion))},
      options_{checked(options, *motion_)},
      grid_{*motion_, model.state().time, end_of(options_, model, *motion_)},
      implicit_{model, options_, control_options(options_, *motion_)},
      step_{model, options_, grid_, implicit_, statistics_},
      chatter_{options_.max_events_per_second} {
  check_components(model, *motion_);
  const IntegratorChoice choice = choose_integrator(model, options_, implicit_.control(), exact_);
  options_.integrator = choice.integrator;
  choice_ = choice.reason;
  check_held(model);
  check_gap_directions(model);
  constexpr std::size_t most_at_one_instant = 64;  // more is rare
  changes_.reserve(most_at_one_instant);
  model_->begin_motion(motion_);
  balance();
  change_regimes_at_end();
  // All energies count from here, those of the elements too.
  if (model_->keeps_energy_accounts()) model_->start_energy_accounts();
}

Transient::~Transient() = default;

void Transient::attach(StepObserver& observer) {
  if (observer.needs_energy_accounts() && !model_->keeps_energy_accounts()) model_->start_energy_accounts();
  observers_.add(observer);
}

StepView Transient::view(bool on_grid) const {
  const PlanVector acceleration = grid_.ground_acceleration();
  return {*model_, acceleration.x, on_grid, step_.stepper().work_rule(), acceleration.y};
}

void Transient::advance() {
  try {
    take_and_report_step();
  } catch (...) {
    model_->return_to_committed_state();
    throw;
  }
}

void Transient::take_and_report_step() {
  if (!model_->prepared() || model_->state().ground_motion != motion_)
    throw InputError{
        "Transient: the model was changed while it is being analysed. Make a new Transient after adding to it, and "
        "after another analysis of it."};
  observers_.start(view(true));
  if (grid_.reaches_end_of_motion(model_->state().time)) end_motion();
  double h = take_step();
  const RegimeScan seen = step_.scan(h);
  if (seen.crossed && options_.events == EventTreatment::located && !is_located(seen, step_.location_tolerance()))
    h = locate_change(step_, h, seen);
  commit(step_.first_part(h));
  observers_.step(view(h == step_.whole().length));
  if (seen.crossed) change_regimes_at_end();
}

// Solves a step of the length that the stepper proposes, or a shorter one if it does not converge or its error is too
// large. Returns the length of the trial step.
double Transient::take_step() {
  Stepper& stepper = exact_ && exact_->applies() ? static_cast<Stepper&>(*exact_) : implicit_;
  for (;; ++statistics_.repeated_steps) {
    step_.begin(stepper);
    const double h = step_.solve_cutting(step_.whole().length);
    if (stepper.accepts(step_.first_part(h))) return h;
  }
}

void Transient::commit(const StepTask& step) {
  model_->commit(step_.stepper().work_rule());
  grid_.accepted(step);
  ++statistics_.accepted_steps;
  statistics_.longest_step = std::max(statistics_.longest_step, step.length);
  statistics_.factorisations = implicit_.factorisations();
  statistics_.newton_iterations = implicit_.newton_iterations();
  implicit_.control().accepted(*model_, step.length, grid_.ground_acceleration());
  collapse_.look(*model_);
}

// The force may jump at the committed state. With the acceleration before the jump the scheme would lose its order.
void Transient::balance() {
  implicit_.balance_committed_state(grid_.ground_acceleration());
  if (exact_) exact_->restart();
}

void Transient::change_regimes_at_end() {
  changes_.clear();
  model_->change_regimes(changes_);
  implicit_.control().restart(*model_, std::ranges::any_of(changes_, &RegimeChange::touched));
  if (changes_.empty()) return;
  balance();
  statistics_.events += static_cast<long>(changes_.size());
  chatter_.count(*model_, changes_);
  observers_.event(view(false), changes_);
}

void Transient::end_motion() {
  if (!grid_.end_motion()) return;
  balance();
  implicit_.control().restart(*model_, false);
  observers_.event(view(false), {});
}

void Transient::finish() { observers_.finish(view(true)); }

void Transient::run(const std::function<bool()>& stop) {
  const double started = process_seconds();
  const auto end = [&] {
    statistics_.cpu_seconds += process_seconds() - started;
    finish();
  };
  observers_.start(view(true));
  try {
    while (!finished() && !(stop && stop())) advance();
  } catch (...) {
    try {
      end();
    } catch (const std::exception&) {
      // The first failure counts.
    }
    throw;
  }
  end();
}

std::vector<std::string> Transient::assumptions() const {
  std::vector<std::string> list =
      assumptions_of(options_, implicit_.control(), longest_step(options_, motion_->time_step()));
  if (!choice_.empty()) list.insert(list.begin(), choice_);
  return list;
}

std::vector<std::string> Transient::warnings() const {
  std::vector<std::string> list = warnings_of(options_, implicit_.control(), *motion_, *model_);
  if (collapse_.collapsed()) list.insert(list.begin(), collapse_.warning());
  return list;
}

}  // namespace moat
