// Time history of a model under a ground motion.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analyses/chatter_guard.hpp"
#include "analyses/exact_between_events.hpp"
#include "analyses/newmark.hpp"
#include "analyses/step_control.hpp"
#include "analyses/step_equations.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "output/case_result.hpp"
#include "output/step_observer.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// What takes a model from one instant to the next.
enum class Integrator {
  /// Newmark's method, for every model.
  newmark,
  /// Exact steps while no gap is closed, Newmark's in contact (analyses/exact_between_events.hpp): for small models
  /// whose springs, dampers and bearings are linear between located events.
  exact_between_events,
};

/// What happens to the step in which an element changes its regime.
enum class EventTreatment {
  /// `inside_the_step` where about a third of the last sixteen steps had a change, or eight elements change in one
  /// step, as in a long street; else `located`. Exact steps are always `located`.
  automatic,
  /// The step ends at the instant of the change, located to location_tolerance: exact, and a step for every change.
  located,
  /// Instant and approach speed come from the interpolated motion, the step is solved again with the new regime from
  /// there on and goes on to its planned end. Steps do not multiply with the number of gaps. A contact that begins and
  /// ends within one step is not felt. A touch whose force jumps (linear dashpots), or whose contact asks for shorter
  /// adapted steps, and changes that do not settle in a few solutions, are located all the same.
  inside_the_step,
};

/// How a time history is computed. Every bound is checked by Transient's constructor.
struct TransientOptions {
  Integrator integrator = Integrator::newmark;

  /// Of Newmark's method. None: the fourth-order scheme in an adaptive step that is inside its bound of stability,
  /// average acceleration elsewhere, in the first step after a touch, and in a fixed step.
  std::optional<NewmarkScheme> scheme{};

  /// >= 0 s. Length of a fixed step; 0: the step adapts itself (next three options), which
  /// Integrator::exact_between_events requires.
  Time step{};

  /// >= 1e-12, < 1. Adaptive step: the error of acceleration that one step should add at any node, relative to the
  /// scale of the absolute acceleration there (analyses/acceleration_scales.hpp); above twice that a step is repeated.
  /// Steps are the longest step divided by powers of two.
  double tolerance = 1.2e-4;

  /// >= 4. Adaptive step: steps within the duration of one contact, estimated with the masses of the joined nodes
  /// alone. 32 give restitution to 1e-3, 1024 to 1e-6. A fixed step with fewer than 32 warns.
  int steps_per_contact = 32;

  /// >= 0 s. Adaptive step, and exact steps: the longest step. It is the interval of the samples divided by the
  /// smallest power of two that gives at most this, at most 2^40; 0: the interval of the samples.
  Time largest_step{};

  /// >= 0, <= 40. Adaptive step: how often the longest step may be halved.
  int largest_halvings = 24;

  /// >= 1. Threads for the evaluation and assembly of elements; results are the same to the last bit. More than one
  /// pays from some ten thousand elements on. Many small cases are better run side by side (analyses/study.hpp).
  int threads = 1;

  /// >= 0 s. Where the analysis ends; 0: at the last sample of the motion.
  Time end{};

  /// > 0, < 1. Largest out-of-balance force of an accepted step at any node, relative to the largest force there. More,
  /// up to 1e-6, passes where it is round-off of the displacements.
  double force_tolerance = 1e-8;

  /// >= 1. Newton iterations before a step is cut.
  int largest_iterations = 20;

  /// >= 0. How often a step that does not converge is cut in half before the analysis gives up.
  int largest_cuts = 12;

  /// > 0 m. A touch or a separation is located until the gap is zero to this. Changes that are no matter of length
  /// are located to the same number: a force's factor that reaches zero (1), a rate that turns (m/s).
  Length location_tolerance = 1e-12 * units::m;

  /// How touches, separations and other changes of regime are treated.
  EventTreatment events = EventTreatment::automatic;

  /// >= 1. Changes of one element in a window of one second of motion, before the analysis gives up.
  int largest_events_per_second = 10000;
};

/// The longest adapted or exact step of an analysis, s, by TransientOptions::largest_step and the interval of the
/// motion's samples, > 0 s.
double longest_step(const TransientOptions& options, double sample_interval);

/// Integrates M a + f(u, v) = -M iota a_g(t) from the model's committed state.
///
/// Newmark's method with Newton-Raphson in every step. Touch and separation of gaps, and yield and unloading of located
/// bearings, are events. A located one ends its step: the step that would cross it is solved again, shorter, until it
/// ends there; then the acceleration is computed anew from the forces after the change, and one odd step leads back to
/// the time grid. Where events are many they may stay inside a step (EventTreatment). The end of the motion is an event
/// too: the ground's acceleration drops to zero there. The step follows the physics (analyses/step_control.hpp) unless
/// it is fixed. With Integrator::exact_between_events steps outside contact are exact instead, and everything else is
/// the same.
///
/// A step that does not converge is cut in half; if that does not help, advance() throws ConvergenceError
/// naming time, step, residual and the worst degree of freedom. It is never accepted.
///
///     Transient analysis{model, motion, {.step = 2.5 * ms}};
///     while (!analysis.finished()) analysis.advance();
class Transient {
 public:
  /// The model must outlive the analysis and not be added to meanwhile. Throws InputError for an option outside its
  /// range, and for a model that already stands at or beyond the end.
  Transient(Model& model, GroundMotion motion, TransientOptions options = {});
  Transient(const Transient&) = delete;
  Transient& operator=(const Transient&) = delete;

  /// Calls the observer from now on; it must outlive the analysis. If it is the first to look at the elements' energy
  /// accounts, these start here.
  void attach(StepObserver& observer);

  [[nodiscard]] bool finished() const;
  /// One accepted step, and the changes of regime inside it or at its end if there are any. Observers attached since
  /// the last step get the start first.
  void advance();
  /// Calls finish() of the observers: the analysis ends here. run() does so itself.
  void finish();
  /// Until finished(), with start() and finish() of the observers, also when a step fails.
  void run();

  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const GroundMotion& motion() const { return motion_; }
  [[nodiscard]] const SolverStatistics& statistics() const { return statistics_; }
  [[nodiscard]] double end_time() const { return end_; }
  /// One sentence each: scheme, step, tolerances.
  [[nodiscard]] std::vector<std::string> assumptions() const;
  /// What may spoil the numbers, with what to do about it.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  [[nodiscard]] StepTask task_of(double h) const;
  void commit(const StepTask& step);
  void plan(double step);
  double take_exact_step();
  double take_newmark_step();
  bool solve(double h);
  double solve_cutting(double h);
  [[nodiscard]] RegimeScan scan(double h) const;
  double locate_change(double h, RegimeScan seen);
  void change_regimes();
  [[nodiscard]] bool goes_on_inside(int crossings) const;
  void foresee_changes();
  bool settle_inside(double h);
  void report_changes_inside();
  void end_motion();
  void start_observers();
  [[nodiscard]] StepView view(bool on_grid) const;
  [[nodiscard]] WorkRule work_rule() const;

  Model* model_;
  GroundMotion motion_;
  TransientOptions options_;
  StepEquations equations_;
  NewtonSolver newton_;
  StepControl control_;
  std::optional<ExactBetweenEvents> exact_;
  ChatterGuard chatter_;
  bool steps_exactly_ = false;  // the step being tried
  NewmarkScheme scheme_{};      // of the step being tried
  double end_ = 0.0;
  StepTask planned_;           // the step being tried, before it was cut or ended at an event
  double ground_ = 0.0;        // acceleration of the ground at the committed state, m/s^2
  bool motion_ended_ = false;  // the ground rests from now on
  Vector acceleration_;
  NewtonReport last_report_;
  std::vector<RegimeChange> changes_;
  double changes_per_step_ = 0.0;  // over the last steps
  struct Follower {
    StepObserver* observer;
    bool started;
  };
  std::vector<Follower> observers_;
  Observed observed_ = Observed::nodes;  // by any observer
  bool only_regimes_ = false;            // exact steps leave out elements that no one looks at
  SolverStatistics statistics_;
};

}  // namespace moat
