#include "performance/moat_histories.hpp"

#include <algorithm>
#include <vector>

#include "output/peaks/peak_trackers.hpp"

namespace moat::performance {
namespace {

// The five peaks alone, as the program around SUNDIALS follows them.
class FivePeakObserver final : public StepObserver {
 public:
  explicit FivePeakObserver(const Model& model) : top_{model.degrees_of_freedom() - 1} {
    for (std::size_t b = 0; b < model.blocks().size(); ++b)
      if (model.blocks()[b]->kind().contacts) gaps_ = b;
  }

  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override {
    sample(view);
    peaks_.add([](std::size_t, double, double turned) { return turned; });
  }
  void event(const StepView& view, std::span<const RegimeChange>) override {
    sample(view);
    peaks_.restart();
  }

  [[nodiscard]] Peaks peaks() const {
    const auto peak = [&](std::size_t i) { return peaks_.magnitude(i); };
    return {peak(0), peak(1), peak(2), peak(3), std::max(peak(4), peak(5))};
  }

 private:
  void sample(const StepView& view) {
    const MotionState& state = view.state.motion();
    const ResultsOf<double> gaps = view.state.elements(gaps_).results().line;
    CommonInstant& next = peaks_.next();
    next.time = state.time;
    std::size_t i = 0;
    const auto add = [&](double value, double rate) {
      next.values[i] = value;
      next.rates[i++] = rate;
    };
    for (const int node : {0, top_}) add(state.displacement[node], state.velocity[node]);
    for (const int node : {0, top_}) add(state.acceleration[node] + view.ground_acceleration.x, state.jerk[node]);
    for (const std::size_t gap : {std::size_t{0}, std::size_t{1}}) add(gaps.forces[gap], gaps.force_rates[gap]);
  }

  int top_;
  std::size_t gaps_ = 0;  // block
  PeakTrackers peaks_{6};
};

}  // namespace

Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options) {
  Transient analysis{model, motion, options};
  FivePeakObserver observer{model};
  analysis.attach(observer);
  analysis.run();
  return observer.peaks();
}

Peaks moat_case(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                ErrorBarMode error_bars, ContactSensitivityMode sensitivity) {
  const CaseResult result =
      run_case(model, motion, {.transient = options, .error_bars = error_bars, .contact_sensitivity = sensitivity});
  return {peak_of(result, "displacement", "base"), peak_of(result, "displacement", "floor 5"),
          peak_of(result, "absolute_acceleration", "base"), peak_of(result, "absolute_acceleration", "floor 5"),
          peak_of(result, "impact_force", "moat")};
}

}  // namespace moat::performance
