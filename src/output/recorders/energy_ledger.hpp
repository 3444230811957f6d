// Where the energy of an analysis went.
#pragma once

#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Keeps the energy balance of an analysis, step by step, in the frame of the ground.
///
/// For average acceleration the change of kinetic energy in a step equals the mean force times the change of
/// displacement exactly, so that `equation_residual` is an identity. For steps of higher order work and input are
/// integrals along the motion inside the step, of order six, and the residual has the error of the integrated
/// velocities: fourth order with Newmark's method. With exact steps it has the error of the integrals alone.
/// `integration_error` is a separate check: it compares the work on every element with its potential and its
/// independently integrated dissipation.
class EnergyLedger final : public StepObserver {
 public:
  bool needs_energy_accounts() const override { return true; }
  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange> changes) override;

  /// Keeps balance() of the last state.
  void finish(const StepView& view) override { at_end_ = balance(view.state); }
  void archive(StateArchive& archive) override {
    archive(time_, displacement_, velocity_, acceleration_, ground_acceleration_, kinetic_at_start_, input_,
            largest_input_, largest_kinetic_);
  }
  /// Returns the balance that finish() kept.
  [[nodiscard]] const EnergyBalance& at_end() const { return at_end_; }

  /// The sums at the committed state, without lists and the worst element. Walks over all elements.
  [[nodiscard]] EnergyBalance totals(const AnalysisState& state) const;
  /// The whole balance at the committed state.
  [[nodiscard]] EnergyBalance balance(const AnalysisState& state) const;

 private:
  void remember(const StepView& view);
  void add_input(const StepView& view, const double* inertia, double ground_before, double ground_now);

  double time_ = 0.0;  // of the last instant, s
  Vector displacement_, velocity_, acceleration_;
  GroundVector ground_acceleration_{};
  EnergyBalance at_end_;
  double kinetic_at_start_ = 0.0;
  double input_ = 0.0, largest_input_ = 0.0, largest_kinetic_ = 0.0;
};

}  // namespace moat
