// Recorders of a script's own whose quantities appear in histories, peaks and report.
#pragma once

#include <span>
#include <vector>

#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// An observer that offers quantities: columns of the histories, peaks, and a chart in the report for each.
///
///     struct RoofTilt final : QuantityRecorder {
///       std::vector<OfferedQuantity> quantities() const override { return {{"roof_tilt", "tower", "m"}}; }
///       void sample(const StepView& view, std::span<double> values) const override { values[0] = ...; }
///     };
///     RoofTilt tilt;
///     return script.run(model, motion, {&tilt});
///
/// Its step() and event() are called before sample(), so that a quantity may depend on the past. A row of the histories
/// inside a step is interpolated linearly; the peak is the largest magnitude at the ends of steps, without error bar
/// and without side.
class QuantityRecorder : public StepObserver {
 public:
  /// Returns the same list whenever it is called.
  [[nodiscard]] virtual std::vector<OfferedQuantity> quantities() const = 0;
  /// Writes one value for each of them, at the committed state.
  virtual void sample(const StepView& view, std::span<double> values) const = 0;

  void start(const StepView&) override {}
  void step(const StepView&) override {}
};

}  // namespace moat
