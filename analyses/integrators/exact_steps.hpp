// Exact steps of a model that is linear between events.
#pragma once

#include <cstddef>
#include <vector>

#include "analyses/integrators/linear_path.hpp"
#include "analyses/integrators/linear_system.hpp"
#include "analyses/time_history/step_control.hpp"
#include "analyses/time_history/stepper.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Steps of a model that is linear between touches, yields and unloadings, by its exact motion
/// (analyses/integrators/linear_path.hpp). The only error is that of the cubic by which elements, changes of regime and
/// peaks are looked at from end to end of a step: a step is so short beside the fastest vibration that this cubic meets
/// it, and within one interval of the motion's samples.
///
/// While a gap is closed applies() is false, and Transient takes Newmark's steps.
class ExactSteps final : public Stepper {
 public:
  /// Matrices are full: this is for small models.
  static constexpr int most_degrees_of_freedom = 50;
  static constexpr double cubics_within = 16.0;  ///< Tolerances by which the cubic of a step may miss a vibration.
  /// The share of the tolerance that Newmark's steps in contact may use: their errors accumulate.
  static constexpr double share_in_contact = 1.0 / 3.0;

  /// The model must be prepared. All must outlive this object; `control` has the longest step and the tolerance, and
  /// chooses the steps in contact. Throws InputError for a model with too many degrees of freedom, an element that is
  /// not linear between events, or an eigenvalue that needs thousands of steps from sample to sample.
  ExactSteps(Model& model, StepControl& control);

  /// Whether the model is linear now: no gap is closed.
  [[nodiscard]] bool applies() const { return model_->contacts_going_on() == 0; }
  /// Elements changed their regime, or the model its state: the linear system must be made again.
  void restart() { system_ = nullptr; }

  double next_length() override;
  void begin(const StepTask& step) override;
  bool solve(const StepTask& part) override;
  bool accepts(const StepTask&) override { return true; }
  WorkRule work_rule() const override { return WorkRule::quadrature; }

 private:
  void linearise();

  Model* model_;
  StepControl* control_;
  std::vector<LinearSystem> systems_;
  const LinearSystem* system_ = nullptr;  // of the current regimes; null: not known yet
  SparseMatrix stiffness_, damping_;
  Vector forces_at_rest_, offset_;  // f0, -M^-1 f0
  LinearPath path_;
};

}  // namespace moat
