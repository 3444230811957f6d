// Observers that follow an analysis step by step.
#pragma once

#include <cstddef>
#include <span>

#include "model/analysis_state.hpp"

namespace moat {

/// The committed state after an accepted step.
struct StepView {
  const Model& model;                  ///< As it was added.
  const AnalysisState& state;          ///< At the time of the step.
  GroundVector ground_acceleration{};  ///< m/s^2, at the state's time
  bool on_grid = true;                 ///< false where the step was cut or ended at a located event, between grid times
  WorkRule work_rule = WorkRule::mean_force;  ///< of the step that led here

  /// m/s^2; of a diaphragm's rotation times its gyration.
  [[nodiscard]] double absolute_acceleration(NodeId node) const {
    if (node == ground) return ground_acceleration.x;
    return state.acceleration(node) + model.moved_by_ground(node, ground_acceleration);
  }
};

/// Receives every accepted step of an analysis. At an event it is called twice for the same instant: step() with the
/// values before the change of regime, event() with those after it. Where the ground stops after the last sample,
/// event() has no changes, and accelerations jump.
class StepObserver {
 public:
  virtual ~StepObserver() = default;

  /// Whether the elements' energy accounts must be kept (ElementStates::energy); steps cost less without them.
  [[nodiscard]] virtual bool needs_energy_accounts() const { return false; }

  /// The state at the start, before the first step.
  virtual void start(const StepView& view) = 0;
  /// After every accepted step.
  virtual void step(const StepView& view) = 0;
  /// After changes of regime.
  virtual void event(const StepView&, std::span<const RegimeChange>) {}
  /// After the last step, also when a step failed and the analysis ends early. A run that was killed behind its last
  /// step, while others with finer steps followed, calls it once more when it goes on.
  virtual void finish(const StepView&) {}
  /// Writes all that step() and event() change, or reads it back after start(), so that a run can go on from a
  /// checkpoint:
  ///
  ///     void archive(StateArchive& archive) override { archive(largest_, time_); }
  ///
  /// Empty for an observer that keeps nothing. One that does not say how throws InputError: its run has no checkpoints.
  virtual void archive(StateArchive&) {
    throw InputError{"An observer of this script has no archive(StateArchive&), which writes and reads its values."};
  }
};

}  // namespace moat
