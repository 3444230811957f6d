// Time history of a model under a ground motion.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyses/events/guards.hpp"
#include "analyses/time_history/observers.hpp"
#include "analyses/time_history/step_grid.hpp"
#include "analyses/time_history/step_method.hpp"
#include "analyses/time_history/step_solver.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "model/analysis_state.hpp"
#include "motions/ground_motion.hpp"
#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Integrates M a + f(u, v) = -M iota a_g(t). The model does not change: the analysis has a state of its own.
///
/// The methods of the integrator (analyses/integrators/integrators.hpp, step_method.hpp) take the steps. Touch and
/// separation of gaps, and yield and unloading of located bearings, are events. A located one ends its step
/// (analyses/events/event_location.hpp): the step that would cross it is solved again, shorter, until it ends there.
/// Then the acceleration is computed again from the forces after the change, and one step of another length ends on the
/// time grid. With EventTreatment::at_end_of_step elements change at the end of the step instead. The end of the motion
/// is an event too: the ground's acceleration drops to zero there. The step follows the physics, as the method
/// proposes, unless it is fixed.
///
/// A step that does not converge is cut in half; if that does not help, advance() throws ConvergenceError
/// naming time, step, residual and the worst place. It is never accepted. The analysis ends, with a warning, where the
/// model has collapsed (analyses/events/guards.hpp).
///
///     Transient analysis{model, motion, {.step = 2.5 * ms}};
///     while (!analysis.finished()) analysis.advance();
class Transient {
 public:
  /// Starts at rest, with the initial displacements and velocities of the model, which must outlive the analysis and
  /// not be added to meanwhile. Throws InputError for an option outside its range.
  Transient(const Model& model, GroundMotion motion, TransientOptions options = {});
  /// Goes on from a state of this model, with energies that count from there. Throws InputError as above, and for a
  /// state that stands at or beyond the end, came to its time under other accelerations of the ground, or is of another
  /// model.
  Transient(const Model& model, GroundMotion motion, AnalysisState state, TransientOptions options = {});
  Transient(const Transient&) = delete;
  Transient& operator=(const Transient&) = delete;
  ~Transient();

  /// Calls the observer from now on; it must outlive the analysis. If it is the first to need the elements' energy
  /// accounts, these start here.
  void attach(StepObserver& observer);

  /// Whether it ended early because the model fell; its last values then depend on where the analysis ended.
  [[nodiscard]] bool collapsed() const { return collapse_.collapsed(); }
  /// Whether the end of the analysis is reached, or the model has collapsed.
  [[nodiscard]] bool finished() const { return collapse_.collapsed() || grid_.finished(state_.time()); }
  /// One accepted step, and the changes of regime at its end if there are any. Observers attached since
  /// the last step get the start first. Where it throws, the state is that before.
  void advance();
  /// Calls finish() of the observers: the analysis ends here. run() does so itself.
  void finish();
  /// Until finished(), with start() and finish() of the observers, also when a step fails. stop: asked before every
  /// step; true ends the run there.
  void run(const std::function<bool()>& stop = {});

  /// Between two steps: writes the analysis with all its observers, or reads it back. The analysis that reads it has
  /// the same model, motion and options, and the same observers in the same order; it then goes on bit for bit. Throws
  /// InputError where these differ, and for an observer or an element that has no archive().
  void archive(StateArchive& archive);

  [[nodiscard]] const Model& model() const { return state_.model(); }    ///< The model that is analysed.
  [[nodiscard]] const AnalysisState& state() const { return state_; }    ///< At the time reached.
  [[nodiscard]] const GroundMotion& motion() const { return *motion_; }  ///< As it is applied.
  [[nodiscard]] SolverStatistics statistics() const;                     ///< Cost up to now.
  [[nodiscard]] double end_time() const { return grid_.end(); }          ///< s
  /// One sentence each: scheme, step, tolerances.
  [[nodiscard]] std::vector<std::string> assumptions() const;
  /// Settings that can make the results inaccurate, with advice.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  void take_and_report_step();
  void commit(const StepTask& step);
  void change_regimes_at_end();
  void end_motion();
  void count_time();
  void restart(bool touched);
  [[nodiscard]] StepView view(bool on_grid) const;

  AnalysisState state_;
  std::shared_ptr<const GroundMotion> motion_;  // shared with the state
  TransientOptions options_;
  StepSettings settings_;
  SolverStatistics statistics_;  // without the costs of methods
  StepGrid grid_;
  std::string identity_;  // for saved states; empty until there is one
  StepMethods methods_;
  StepMethod* method_ = nullptr;  // of the last step, or the first of all
  StepSolver step_;
  ChatterGuard chatter_;
  CollapseGuard collapse_;
  std::optional<double> counted_until_;  // s of the process, in run()
  int vain_cuts_ = 0;                    // in succession: steps that event location cut, without a change at their end
  Observers observers_;
  std::vector<RegimeChange> changes_;  // of the last step that had any
};

}  // namespace moat
