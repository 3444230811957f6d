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
  check.that(options.scheme.beta > 0.0 && options.scheme.beta <= 0.5, "scheme.beta", options.scheme.beta, "1",
             "> 0 and <= 0.5", "Use NewmarkScheme::average_acceleration() or linear_acceleration().");
  check.not_negative("step", options.step);
  check.that(options.integrator == Integrator::newmark || options.step.si() == 0.0, "step", options.step.si(), "s",
             "0 s with Integrator::exact_between_events", "It steps from sample to sample, and adapts in contact.");
  check.that(options.tolerance > 0.0 && options.tolerance < 1.0, "tolerance", options.tolerance, "1", "> 0 and < 1",
             "1.2e-4 is the default.");
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

// Gershgorin's bound on the largest eigenvalue of M^-1 K with initial stiffness, 1/s^2.
double bound_of_squared_frequency(const Model& model) {
  SparseMatrix stiffness = model.pattern();
  model.assemble_linear_stiffness(StiffnessStage::initial, stiffness);
  double bound = 0.0;
  for (int column = 0; column < stiffness.size; ++column) {
    double sum = 0.0;
    for (int k = stiffness.column_starts[static_cast<std::size_t>(column)];
         k < stiffness.column_starts[static_cast<std::size_t>(column) + 1]; ++k)
      sum += std::abs(stiffness.values[static_cast<std::size_t>(k)]);
    bound = std::max(bound, sum / model.masses()[column]);
  }
  return bound;
}

// The first multiple of `step` after `time`; one that is closer than round-off is skipped.
double next_grid_time(double time, double step) {
  constexpr double coincident = 1e-6;
  const double position = time / step;
  return (static_cast<double>(static_cast<long>(position + coincident)) + 1.0) * step;
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
      equations_{model, options.scheme},
      newton_{equations_, {.tolerance = options.force_tolerance, .largest_iterations = options.largest_iterations}} {
  control_ = StepControl{model,
                         {.fixed_step = options_.step.si(),
                          .grid_interval = longest_step(options_, motion_.time_step()),
                          .tolerance = options_.tolerance,
                          .steps_per_contact = options_.steps_per_contact,
                          .largest_halvings = options_.largest_halvings}};
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
  event_window_start_ = model.state().time;
  ground_ = motion_.acceleration_at(model.state().time);
  equations_.balance_committed_state(ground_);
  change_regimes();
  control_.restart(model, ground_);
  stiffest_squared_ = bound_of_squared_frequency(model);
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

StepView Transient::view(bool on_grid) const { return {*model_, ground_, on_grid}; }

bool Transient::finished() const { return model_->state().time >= end_ * (1.0 - 1e-12); }

// Grid times are multiples of the step, not sums of steps, and the last sample is not passed by round-off.
double Transient::time_after(double h) const { return h == planned_ ? target_ : model_->state().time + h; }

double Transient::ground_after(double h) const {
  return h == planned_ ? target_ground_ : motion_.acceleration_at(model_->state().time + h);
}

// One step of length h from the committed state into the trial state. Not accepted yet.
bool Transient::solve(double h) {
  const double end = time_after(h);
  if (steps_exactly_) {
    exact_->solve(h, end);
    if (only_regimes_)
      model_->evaluate_regimes();
    else
      model_->evaluate();
    return true;
  }
  equations_.begin(h, end, ground_after(h));
  acceleration_ = model_->state().acceleration.head(model_->degrees_of_freedom());
  last_report_ = newton_.solve(acceleration_);
  statistics_.newton_iterations += last_report_.iterations;
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
                             " of the largest force (allowed: " + to_text(options_.force_tolerance) + "), worst at \"" +
                             worst_name +
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

void Transient::count_event(double time) {
  if (time - event_window_start_ > 1.0) {
    event_window_start_ = time;
    events_in_window_ = 0;
  }
  ++statistics_.events;
  if (++events_in_window_ <= options_.largest_events_per_second) return;
  throw Error{"More than " + std::to_string(options_.largest_events_per_second) +
              " touches and separations within one second before t = " + to_text(time) +
              " s: a contact chatters. Check impact stiffness and damping, or raise "
              "TransientOptions::largest_events_per_second."};
}

void Transient::change_regimes() {
  changes_.clear();
  model_->change_regimes(changes_);
  if (changes_.empty()) return;
  // The force may jump; a stale acceleration would cost second order.
  equations_.balance_committed_state(ground_);
  if (exact_) exact_->restart();
  count_event(model_->state().time);
  control_.restart(*model_, ground_);
  const StepView after = view(false);
  for (const Follower& follower : observers_) follower.observer->event(after, changes_);
}

// The step to try leads to the next grid time.
void Transient::plan(double step) {
  const double start = model_->state().time;
  target_ = std::min(next_grid_time(start, step), end_);
  // Exactly the nominal length where it is meant, so that the tangent and its factors stay the same.
  planned_ = std::abs(target_ - start - step) < 1e-9 * step ? step : target_ - start;
  target_ground_ = motion_.acceleration_at(target_);
}

double Transient::take_exact_step() {
  plan(exact_->step_length());
  const double start = model_->state().time;
  // The ground's acceleration drops to zero after the last sample, and does not go there linearly.
  const bool after_motion = start >= motion_.duration() * (1.0 - 1e-12);
  exact_->begin(planned_, after_motion ? 0.0 : ground_, target_ground_);
  solve(planned_);
  return planned_;
}

double Transient::take_newmark_step() {
  for (;; ++statistics_.repeated_steps) {
    plan(control_.next_step(*model_));
    const double h = solve_cutting(planned_);
    if (control_.accepts(*model_, h, ground_after(h))) return h;
  }
}

void Transient::advance() {
  if (!model_->prepared())
    throw InputError{
        "Transient: the model was changed while it is being analysed. Make a new Transient after adding to it."};
  start_observers();
  steps_exactly_ = exact_ && exact_->applies();
  double h = steps_exactly_ ? take_exact_step() : take_newmark_step();
  const RegimeScan seen = scan(h);
  const bool located = !seen.returned && seen.margin < 0.0 && seen.margin >= -options_.location_tolerance.si();
  if (seen.crossed && !located) h = locate_change(h, seen);
  commit(h);
  const StepView accepted = view(h == planned_);
  for (const Follower& follower : observers_) follower.observer->step(accepted);
  if (seen.crossed) change_regimes();
}

void Transient::commit(double h) {
  const double acceleration_of_ground = ground_after(h);
  model_->commit();
  ground_ = acceleration_of_ground;
  ++statistics_.accepted_steps;
  statistics_.longest_step = std::max(statistics_.longest_step, h);
  statistics_.factorisations = equations_.factorisations();
  if (steps_exactly_)
    control_.passed(*model_, ground_);
  else
    control_.accepted(*model_, h, ground_);
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
                                     " of the largest acceleration and to " +
                                     std::to_string(options_.steps_per_contact) + " steps per contact, at most " +
                                     to_text(longest_step(options_, motion_.time_step())) + " s"
                               : "fixed step of " + to_text(options_.step.si()) + " s";
  const std::string exact = exact_ ? "Exact steps from sample to sample while no gap is closed; in contact: " : "";
  return {exact + "Newmark's method, beta = " + to_text(options_.scheme.beta) + ", gamma = 1/2, " + step +
              "; every step solved until the forces balance to " + to_text(options_.force_tolerance) +
              " of the largest force.",
          "Touch and separation located until the gap is zero to " + to_text(options_.location_tolerance.si()) +
              " m, acceleration recomputed there.",
          "Ground acceleration linear between samples; the system starts at rest at the first sample unless "
          "initial values are given."};
}

std::vector<std::string> Transient::warnings() const {
  constexpr double enough = 32.0;
  const double fewest = control_.fewest_steps_per_contact();
  std::vector<std::string> list;
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
  const double limit = options_.scheme.stability_limit() / std::sqrt(stiffest_squared_);
  if (step > limit)
    list.push_back("The fixed step is longer than the " + to_text(limit) +
                   " s up to which beta = " + to_text(options_.scheme.beta) +
                   " is sure to be stable. Take a shorter one or average acceleration.");
  if (fewest >= enough) return list;
  list.push_back("The fixed step divides the shortest contact into " + to_text(fewest) +
                 " steps only; with fewer than " + to_text(enough) +
                 " the restitution is off by more than 0.001. Take a step of at most " +
                 to_text(options_.step.si() * fewest / enough) + " s, or leave the step out: it adapts itself.");
  return list;
}

}  // namespace moat
