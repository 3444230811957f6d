#include "performance/moat_five_storeys.hpp"

#include <array>
#include <moat.hpp>

#include "output/peak_recorder.hpp"
#include "output/peak_tracker.hpp"
#include "paper/paper_building.hpp"

namespace moat::performance {
namespace {

// The same work as a bare loop does for its peaks.
class PeakObserver final : public StepObserver {
 public:
  explicit PeakObserver(const Model& model) : top_{model.degrees_of_freedom() - 1} {
    for (const auto& block : model.blocks())
      if (block->size() > 0 && block->info(0).kind == ElementKind::gap) gaps_ = block.get();
  }

  // The gaps' force is all it wants of elements.
  Observed observed() const override { return Observed::nodes; }
  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override {
    const auto [values, rates] = sample(view);
    for (std::size_t i = 0; i < values.size(); ++i) trackers_[i].add(view.model.state().time, values[i], rates[i]);
  }
  void event(const StepView& view, std::span<const RegimeChange>) override {
    const auto [values, rates] = sample(view);
    for (std::size_t i = 0; i < values.size(); ++i) trackers_[i].restart(view.model.state().time, values[i], rates[i]);
  }
  void finish(const StepView&) override {}

  [[nodiscard]] Peaks peaks() const {
    Peaks peaks{};
    for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i] = trackers_[i].magnitude();
    return peaks;
  }

 private:
  // Values and rates.
  [[nodiscard]] std::pair<Peaks, Peaks> sample(const StepView& view) const {
    const MotionState& state = view.model.state();
    const auto forces = gaps_->forces(), rates = gaps_->force_rates();
    const std::size_t closed = forces[0] > forces[1] ? 0 : 1;
    return {{state.displacement[0], state.displacement[top_], state.acceleration[0] + view.ground_acceleration,
             state.acceleration[top_] + view.ground_acceleration, forces[closed]},
            {state.velocity[0], state.velocity[top_], state.jerk[0], state.jerk[top_], rates[closed]}};
  }

  int top_;
  const ElementBlock* gaps_ = nullptr;
  std::array<PeakTracker, 5> trackers_;
};

double peak_of(const std::vector<Peak>& peaks, std::string_view quantity, std::string_view where) {
  for (const Peak& peak : peaks)
    if (peak.quantity == quantity && peak.where == where) return peak.value;
  throw InputError{"There is no peak " + std::string{quantity} + " of " + std::string{where} + "."};
}

}  // namespace

Model five_storey_model(bool locate_yield) {
  using namespace units;
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 5,
                                                 .floor_mass = paper::floor_mass,
                                                 .storey_stiffness = 1 * GN / m,
                                                 .damping = RayleighDamping{.ratio = 0.05},
                                                 .base_mass = paper::base_mass,
                                                 .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 19.3 * MN / m,
                                                                                .locate_yield = locate_yield}});
  add(model, Moat{.around = building.base,
                  .clearance = paper::paper_gap,
                  .law = HertzDamp{.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution}});
  model.prepare();
  return model;
}

Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options) {
  Model copy = model;
  Transient analysis{copy, motion, options};
  PeakObserver observer{copy};
  analysis.attach(observer);
  analysis.run();
  return observer.peaks();
}

Peaks moat_peaks_of_all_channels(const Model& model, const GroundMotion& motion, const TransientOptions& options) {
  Model copy = model;
  Transient analysis{copy, motion, options};
  PeakRecorder recorder{copy};
  analysis.attach(recorder);
  analysis.run();
  const std::vector<Peak> peaks = recorder.peaks();
  return {peak_of(peaks, "displacement", "base"), peak_of(peaks, "displacement", "floor 5"),
          peak_of(peaks, "absolute_acceleration", "base"), peak_of(peaks, "absolute_acceleration", "floor 5"),
          peak_of(peaks, "impact_force", "moat")};
}

}  // namespace moat::performance
