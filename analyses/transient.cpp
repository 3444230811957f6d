#include "analyses/transient.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {
namespace {

TransientOptions checked(const TransientOptions& options) {
  const Check check{"TransientOptions", ""};
  const double beta = options.scheme.value_or(NewmarkScheme{}).beta;
  check.that(beta > 0.0 && beta <= 0.5, "scheme.beta", beta, "1", "> 0 and <= 0.5",
             "Use NewmarkScheme::average_acceleration(), linear_acceleration() or fourth_order().");
  check.that(!options.scheme || !options.scheme->corrects_velocity || *options.scheme == NewmarkScheme::fourth_order(),
             "scheme.beta", beta, "1", "1/12 with corrects_velocity", "Use NewmarkScheme::fourth_order().");
  check.not_negative("step", options.step);
  check.that(options.integrator == Integrator::newmark || options.step.si() == 0.0, "step", options.step.si(), "s",
             "0 s with Integrator::exact_between_events", "It steps from sample to sample, and adapts in contact.");
  check.that(options.tolerance >= 1e-12 && options.tolerance < 1.0, "tolerance", options.tolerance, "1",
             ">= 1e-12 and < 1", to_text(TransientOptions{}.tolerance) + " is the default; below 1e-12 is round-off.");
  check.that(options.steps_per_contact >= 4, "steps_per_contact", options.steps_per_contact, "1", ">= 4");
  check.not_negative("largest_step", options.largest_step);
  check.between("largest_halvings", options.largest_halvings, 0, 40, "1");
  check.that(options.threads >= 1, "threads", options.threads, "1", ">= 1");
  check.not_negative("end", options.end);
  check.that(options.force_tolerance > 0.0 && options.force_tolerance < 1.0, "force_tolerance", options.force_tolerance,
             "1", "> 0 and < 1");
  check.that(options.largest_iterations >= 1, "largest_iterations", options.largest_iterations, "1", ">= 1");
  check.that(options.largest_cuts >= 0, "largest_cuts", options.largest_cuts, "1", ">= 0");
  check.positive("location_tolerance", options.location_tolerance);
  check.that(options.largest_events_per_second >= 1, "largest_events_per_second", options.largest_events_per_second,
             "1", ">= 1");
  return options;
}

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Errors of acceleration are judged on at least this share of the peak ground acceleration: a place that feels less is
// at rest, or free.
constexpr double share_of_ground_that_counts = 0.02;

// The first multiple of `step` after `time`; one that is closer than round-off is skipped.
double next_grid_time(double time, double step) {
  const double position = time / step;
  const double coincident = std::max(1e-6, 8.0 * std::numeric_limits<double>::epsilon() * position);
  return (std::floor(position + coincident) + 1.0) * step;
}

}  // namespace

double longest_step(const TransientOptions& options, double sample_interval) {
  constexpr int most_halvings = 40;
  double step = sample_interval;
  if (options.largest_step.si() <= 0.0) return step;
  // Half of a step that was given as a power of two must not be missed by round-off.
  for (int halvings = 0; halvings < most_halvings && step > options.largest_step.si() * (1.0 + 1e-9); ++halvings)
    step *= 0.5;
  return step;
}

Transient::Transient(Model& model, GroundMotion motion, TransientOptions options)
    : model_{&model},
      motion_{std::move(motion)},
      options_{checked(options)},
      equations_{model},
      newton_{equations_, {.tolerance = options.force_tolerance, .largest_iterations = options.largest_iterations}},
      control_{model,
               {.fixed_step = options_.step.si(),
                .grid_interval = longest_step(options_, motion_.time_step()),
                .tolerance = options_.tolerance,
                .steps_per_contact = options_.steps_per_contact,
                .largest_halvings = options_.largest_halvings,
                .scheme = options_.scheme,
                .lowest_acceleration = share_of_ground_that_counts * motion_.peak_acceleration().si()}},
      chatter_{options_.largest_events_per_second} {
  if (options_.integrator == Integrator::exact_between_events)
    exact_.emplace(model, longest_step(options_, motion_.time_step()));
  end_ = options_.end.si() > 0.0 ? options_.end.si() : motion_.duration();
  Check{"Transient", motion_.name()}.that(
      model.state().time < end_,
      "the model stands at t = " + to_text(model.state().time) + " s, and the analysis ends at " + to_text(end_) +
          " s.",
      "Copy the model before its first analysis to use it again, or give a later TransientOptions::end.");
  acceleration_.setZero(model.degrees_of_freedom());
  model.use_threads(options_.threads);
  changes_.reserve(64);  // more at one instant is rare
  ground_ = motion_.acceleration_at(model.state().time);
  equations_.balance_committed_state(ground_);
  change_regimes();
}

void Transient::attach(StepObserver& observer) {
  if (observer.observed() == Observed::energy && observed_ != Observed::energy) model_->start_energy_account();
  observed_ = std::max(observed_, observer.observed());
  observers_.push_back({&observer, false});
}

void Transient::start_observers() {
  const StepView now = view(true);
  for (Follower& follower : observers_) {
    if (follower.started) continue;
    follower.started = true;
    follower.observer->start(now);
  }
}

void Transient::finish() {
  const StepView now = view(true);
  for (const Follower& follower : observers_) follower.observer->finish(now);
}

StepView Transient::view(bool on_grid) const { return {*model_, ground_, on_grid, work_rule()}; }

// Of the step being tried.
WorkRule Transient::work_rule() const {
  return steps_exactly_ || scheme_.order() > 2 ? WorkRule::quadrature : WorkRule::mean_force;
}

bool Transient::finished() const { return model_->state().time >= end_ * (1.0 - 1e-12); }

// The first h seconds of the planned step. Grid times are multiples of the step, not sums of steps, and the last sample
// is not passed by round-off.
StepTask Transient::task_of(double h) const {
  if (h == planned_.length) return planned_;
  const double end = model_->state().time + h;
  return {h, end, motion_ended_ ? 0.0 : motion_.acceleration_at(end), planned_.ground_jerk};
}

// One step of length h from the committed state into the trial state. Not accepted yet.
bool Transient::solve(double h) {
  const StepTask task = task_of(h);
  if (steps_exactly_) {
    exact_->solve(h, task.end_time, only_regimes_);
    if (only_regimes_)
      model_->evaluate_regimes();
    else
      model_->evaluate();
    model_->evaluate_rates();
    return true;
  }
  equations_.begin(task, scheme_, acceleration_);
  last_report_ = newton_.solve(acceleration_);
  statistics_.newton_iterations += last_report_.iterations;
  if (last_report_.converged) equations_.complete();
  return last_report_.converged;
}

// Solves a step, cut in half until it converges; returns the length that did.
double Transient::solve_cutting(double h) {
  for (int cut = 0; cut <= options_.largest_cuts; ++cut, h *= 0.5) {
    if (solve(h)) return h;
    ++statistics_.rejected_steps;
  }
  h *= 2.0;
  const NodeId worst{last_report_.worst_degree_of_freedom};
  const std::string worst_name{model_->node_name(worst)};
  const double time = model_->state().time;
  throw ConvergenceError{"The step from t = " + to_text(time) + " s did not converge although it was cut to " +
                             to_text(h) + " s: the forces are out of balance by " + to_text(last_report_.residual) +
                             " of the largest force there (allowed: " + to_text(options_.force_tolerance) +
                             "), worst at \"" + worst_name +
                             "\". Check the parameters of the elements there; results up to this time are kept.",
                         time, h, last_report_.residual, worst_name};
}

// Looks for a change of regime in the trial step of length h.
RegimeScan Transient::scan(double h) const {
  // The middle of the band [-tolerance, 0) where a located step may end: beyond the change, not before it.
  return model_->scan_regimes(h, -0.5 * options_.location_tolerance.si());
}

// The trial step of length h crosses a change of regime, as `seen` tells. Solves shorter steps until one ends
// just beyond the first change and returns its length. Where one does not converge, what it was cut to may end before.
double Transient::locate_change(double h, RegimeScan seen) {
  const double tolerance = options_.location_tolerance.si();
  const double shortest = 4.0 * std::numeric_limits<double>::epsilon() * (model_->state().time + h);
  double before = 0.0, beyond = h;
  double margin_before = 0.0;
  double margin_beyond = seen.margin;
  double next = seen.fraction * h;
  constexpr int most_solves = 100;
  for (int count = 0; count < most_solves; ++count) {
    const double width = beyond - before;
    // A guess outside the bracket, or slow progress: halve it.
    if (!(next > before && next < beyond) || (count > 8 && count % 2 == 0)) next = before + 0.5 * width;
    if (width <= shortest) next = beyond;
    ++statistics_.event_solves;
    if (!solve(next)) {
      // A shorter step may end before the change, or beyond it by any amount.
      const double shorter = solve_cutting(0.5 * next);
      seen = scan(shorter);
      return seen.crossed ? locate_change(shorter, seen) : shorter;
    }
    seen = scan(next);
    if (seen.margin < 0.0 && (seen.margin >= -tolerance || width <= shortest)) return next;
    if (seen.crossed && width <= shortest) return next;  // there and back within round-off: no change
    if (seen.crossed) {
      beyond = next;
      margin_beyond = seen.margin;
      next = seen.fraction * beyond;
    } else {
      // The interpolant of the longer step saw a change and its return; this step has none. From its end on the
      // rest is looked at again.
      if (width <= shortest || margin_beyond >= 0.0) return next;
      before = next;
      margin_before = seen.margin;
      const double fall = margin_before - margin_beyond;
      next = margin_beyond < 0.0 ? before + (beyond - before) * (margin_before + 0.5 * tolerance) / fall : beyond;
    }
  }
  throw ConvergenceError{"A touch or separation after t = " + to_text(model_->state().time) +
                             " s could not be located to " + to_text(tolerance) +
                             " m. Raise TransientOptions::location_tolerance; results up to this time are kept.",
                         model_->state().time, beyond, seen.margin, "a gap"};
}

void Transient::change_regimes() {
  changes_.clear();
  model_->change_regimes(changes_);
  const bool touched = std::ranges::any_of(changes_, &RegimeChange::touched);
  control_.restart(*model_, touched);
  if (changes_.empty()) return;
  // The force may jump; a stale acceleration would cost the order of the scheme.
  equations_.balance_committed_state(ground_);
  if (exact_) exact_->restart();
  statistics_.events += static_cast<long>(changes_.size());
  chatter_.count(*model_, changes_);
  const StepView after = view(false);
  for (const Follower& follower : observers_) follower.observer->event(after, changes_);
}

// After its last sample the ground rests; its acceleration drops to zero and does not go there linearly.
void Transient::end_motion() {
  motion_ended_ = true;
  if (ground_ == 0.0) return;
  ground_ = 0.0;
  equations_.balance_committed_state(ground_);
  if (exact_) exact_->restart();
  control_.restart(*model_, false);
  const StepView after = view(false);
  for (const Follower& follower : observers_) follower.observer->event(after, {});
}

// The step to try leads to the next grid time.
void Transient::plan(double step) {
  const double start = model_->state().time;
  double target = std::min(next_grid_time(start, step), end_);
  if (!motion_ended_) target = std::min(target, motion_.duration());
  // Exactly the nominal length where it is meant, so that the tangent and its factors stay the same.
  const double length = std::abs(target - start - step) < 1e-9 * step ? step : target - start;
  const double end_acceleration = motion_ended_ ? 0.0 : motion_.acceleration_at(target);
  planned_ = {length, target, end_acceleration, (end_acceleration - ground_) / length};
}

double Transient::take_exact_step() {
  plan(exact_->step_length());
  exact_->begin(planned_.length, ground_, planned_.ground_acceleration);
  solve(planned_.length);
  return planned_.length;
}

double Transient::take_newmark_step() {
  for (bool foresee = goes_on_inside(0);; ++statistics_.repeated_steps) {
    const StepControl::Step step = control_.next_step(*model_);
    plan(step.length);
    scheme_ = step.scheme;
    changes_.clear();
    if (foresee) foresee_changes();
    const double h = solve_cutting(planned_.length);
    // Instants that were foreseen belong to the whole step.
    const bool cut = h != planned_.length && !changes_.empty();
    if (!cut && control_.accepts(*model_, task_of(h), scheme_, changes_)) return h;
    model_->undo_changes_inside();
    foresee = foresee && !cut;
  }
}

void Transient::advance() {
  if (!model_->prepared())
    throw InputError{
        "Transient: the model was changed while it is being analysed. Make a new Transient after adding to it."};
  start_observers();
  if (!motion_ended_ && model_->state().time >= motion_.duration() * (1.0 - 1e-12)) end_motion();
  steps_exactly_ = exact_ && exact_->applies();
  double h = steps_exactly_ ? take_exact_step() : take_newmark_step();
  RegimeScan seen = scan(h);
  const bool inside = (seen.crossed || !changes_.empty()) && goes_on_inside(seen.crossings);
  const bool settled = inside && settle_inside(h);
  if (inside && !settled) {
    h = solve_cutting(h);
    seen = scan(h);
  }
  const bool located = !seen.returned && seen.margin < 0.0 && seen.margin >= -options_.location_tolerance.si();
  if (seen.crossed && !settled && !located) h = locate_change(h, seen);
  commit(task_of(h));
  const StepView accepted = view(h == planned_.length);
  for (const Follower& follower : observers_) follower.observer->step(accepted);
  if (settled)
    report_changes_inside();
  else if (seen.crossed)
    change_regimes();
  constexpr double lately = 1.0 / 16.0;  // weight of the last step
  changes_per_step_ += lately * (std::min(static_cast<double>(changes_.size()), 1.0) - changes_per_step_);
}

bool Transient::goes_on_inside(int crossings) const {
  constexpr double many = 0.3;
  constexpr int many_at_once = 8;
  return !steps_exactly_ &&
         (options_.events == EventTreatment::inside_the_step ||
          (options_.events == EventTreatment::automatic && (changes_per_step_ > many || crossings >= many_at_once)));
}

// Changes of regime inside the planned step as the motion predicts them: they need no second solution then.
void Transient::foresee_changes() {
  equations_.predict(planned_, scheme_, acceleration_);
  const bool possible =
      model_->change_regimes_inside(planned_.length, -0.5 * options_.location_tolerance.si(), changes_) &&
      control_.is_short_enough(planned_.length, model_->shortest_contact());
  if (possible) return;
  model_->undo_changes_inside();
  changes_.clear();
}

// Solves the trial step of length h again with the regimes that elements enter inside it. False if that is not
// possible: the regimes are as before, the trial state is to be solved again.
bool Transient::settle_inside(double h) {
  constexpr int most_passes = 4;
  const double aim = -0.5 * options_.location_tolerance.si();
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::size_t before = changes_.size();
    bool possible = model_->change_regimes_inside(h, aim, changes_);
    if (possible && changes_.size() == before) return true;
    possible = possible && control_.is_short_enough(h, model_->shortest_contact());
    ++statistics_.event_solves;
    if (possible && solve(h)) continue;
    break;
  }
  model_->undo_changes_inside();
  changes_.clear();
  return false;
}

void Transient::report_changes_inside() {
  model_->open_gaps(changes_);
  if (changes_.empty()) return;
  statistics_.events += static_cast<long>(changes_.size());
  statistics_.changes_inside += static_cast<long>(changes_.size());
  chatter_.count(*model_, changes_);
  control_.changed_inside(*model_);
  const StepView after = view(false);
  for (const Follower& follower : observers_) follower.observer->event(after, changes_);
}

void Transient::commit(const StepTask& step) {
  model_->commit(work_rule());
  ground_ = step.ground_acceleration;
  ++statistics_.accepted_steps;
  statistics_.longest_step = std::max(statistics_.longest_step, step.length);
  statistics_.factorisations = equations_.factorisations();
  control_.accepted(*model_, step.length, ground_);
}

void Transient::run() {
  const double started = process_seconds();
  start_observers();
  // Who steps by hand may look at the model after every step.
  only_regimes_ = observed_ == Observed::nodes && !model_->keeps_energy_accounts();
  const auto end = [&] {
    if (only_regimes_) model_->refresh();
    only_regimes_ = false;
    statistics_.cpu_seconds += process_seconds() - started;
    finish();
  };
  try {
    while (!finished()) advance();
  } catch (...) {
    end();
    throw;
  }
  end();
}

std::vector<std::string> Transient::assumptions() const {
  const std::string step = control_.adaptive()
                               ? "step adapted to an error of " + to_text(options_.tolerance) +
                                     " of each node's acceleration and to " +
                                     std::to_string(options_.steps_per_contact) + " steps per contact, at most " +
                                     to_text(longest_step(options_, motion_.time_step())) + " s"
                               : "fixed step of " + to_text(options_.step.si()) + " s";
  const std::string exact = exact_ ? "Exact steps from sample to sample while no gap is closed; in contact: " : "";
  std::string scheme = "beta = " + to_text(options_.scheme.value_or(NewmarkScheme{}).beta) + ", gamma = 1/2, ";
  if (control_.adaptive() && !options_.scheme)
    scheme =
        "gamma = 1/2, beta = 1/12 with velocities corrected to fourth order (beta = 1/4 after a touch, and where a "
        "step is too long for that), ";
  return {
      exact + "Newmark's method, " + scheme + step + "; every step solved until the forces at each node balance to " +
          to_text(options_.force_tolerance) + " of the largest force there.",
      "Touch and separation located until the gap is zero to " + to_text(options_.location_tolerance.si()) +
          " m, acceleration recomputed there" +
          (statistics_.changes_inside > 0 ? "; " + std::to_string(statistics_.changes_inside) + " of " +
                                                std::to_string(statistics_.events) + " changes crossed inside a step."
                                          : "."),
      "Ground acceleration linear between samples and zero after the last one; the system starts at rest at the "
      "first sample unless initial values are given."};
}

std::vector<std::string> Transient::warnings() const {
  constexpr double enough = 32.0;
  const double fewest = control_.fewest_steps_per_contact();
  std::vector<std::string> list;
  constexpr double harmful = 1e-3;
  if (control_.largest_round_off() > harmful)
    list.push_back("The stiffness at \"" + std::string{model_->node_name(control_.place_of_round_off())} +
                   "\" is so high that round-off is " + to_text(100.0 * control_.largest_round_off()) +
                   " % of the acceleration there. Check the parameters of its elements; a softer spring or a rigid "
                   "connection (one node) gives a sharper answer.");
  if (control_.adaptive()) {
    if (fewest < options_.steps_per_contact)
      list.push_back("The shortest contact was divided into " + to_text(fewest) + " steps only instead of " +
                     std::to_string(options_.steps_per_contact) +
                     ", because the interval of the motion may not be halved more often. Raise "
                     "TransientOptions::largest_halvings.");
    return list;
  }
  const double step = options_.step.si(), interval = motion_.time_step();
  const double per_interval = interval / step;
  if (std::abs(per_interval - std::round(per_interval)) > 1e-6 * per_interval || per_interval < 1.0 - 1e-6)
    list.push_back("The fixed step of " + to_text(step) + " s does not divide the motion's interval of " +
                   to_text(interval) + " s: samples between steps are not felt. Take " + to_text(interval) +
                   " s divided by a whole number.");
  const NewmarkScheme scheme = options_.scheme.value_or(NewmarkScheme::average_acceleration());
  const double limit = scheme.stability_limit() / std::sqrt(control_.stiffest_squared());
  if (step > limit)
    list.push_back("The fixed step is longer than the " + to_text(limit) + " s up to which beta = " +
                   to_text(scheme.beta) + " is sure to be stable. Take a shorter one or average acceleration.");
  if (fewest >= enough) return list;
  list.push_back("The fixed step divides the shortest contact into " + to_text(fewest) +
                 " steps only; with fewer than " + to_text(enough) +
                 " the restitution is off by more than 0.001. Take a step of at most " +
                 to_text(options_.step.si() * fewest / enough) + " s, or leave the step out: it adapts itself.");
  return list;
}

}  // namespace moat
