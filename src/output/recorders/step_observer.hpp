// Observers that follow an analysis step by step.
#pragma once

#include <cstddef>
#include <span>

#include "model/model.hpp"

namespace moat {

/// The committed state after an accepted step.
struct StepView {
  const Model& model;                ///< At the time of the step.
  double ground_acceleration = 0.0;  ///< m/s^2, at the state's time; in plan its x component
  bool on_grid = true;               ///< false where the step was cut or ended at a located event, between grid times
  WorkRule work_rule = WorkRule::mean_force;  ///< of the step that led here
  double ground_acceleration_y = 0.0;         ///< m/s^2; 0 on a line

  [[nodiscard]] PlanVector ground() const { return {ground_acceleration, ground_acceleration_y}; }  ///< m/s^2.
  /// m/s^2; of a diaphragm's rotation times its gyration.
  [[nodiscard]] double absolute_acceleration(NodeId node) const {
    if (node == moat::ground) return ground_acceleration;
    return model.acceleration(node) + model.ground_shares().of(ground(), node.index);
  }
};

/// Receives every accepted step of an analysis. At an event it is called twice for the same instant: step() with the
/// values before the change of regime, event() with those after it. Where the ground stops after the last sample,
/// event() has no changes, and accelerations jump.
class StepObserver {
 public:
  virtual ~StepObserver() = default;

  /// Whether the elements' energy accounts must be kept (ElementBlock::energy); steps cost less without them.
  [[nodiscard]] virtual bool needs_energy_accounts() const { return false; }

  /// The state at the start, before the first step.
  virtual void start(const StepView& view) = 0;
  /// After every accepted step.
  virtual void step(const StepView& view) = 0;
  /// After changes of regime.
  virtual void event(const StepView&, std::span<const RegimeChange>) {}
  /// After the last step, also when a step failed and the analysis ends early.
  virtual void finish(const StepView&) {}
};

}  // namespace moat
