// The table of impacts.
#pragma once

#include <vector>

#include "output/files/case_result.hpp"
#include "output/peaks/peak_trackers.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Lists every contact from touch until the gap opens, with the true rate of the indentation at touch as approach
/// speed. The restitution of the law alone is filled in at finish().
///
/// The rebound ratio is NaN in three cases. A contact may still last at the end: it is listed with its duration so far.
/// One without approach, closed when the model starts (time 0) or touched at a speed <= 0, has no restitution either.
/// The third is one driven after a slow touch, which would rebound with more than `largest_rebound_ratio`.
class ImpactRecorder final : public StepObserver {
 public:
  /// Without energies an impact has its touch alone, where, start and approach_speed; energies cost a third of an
  /// analysis.
  explicit ImpactRecorder(bool with_energies = true) : with_energies_{with_energies} {}

  bool needs_energy_accounts() const override { return with_energies_; }
  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange> changes) override;
  void finish(const StepView& view) override;
  void archive(StateArchive& archive) override { archive(impacts_, listed_, ongoing_); }

  /// In order of touch.
  [[nodiscard]] const std::vector<Impact>& impacts() const { return impacts_; }

  /// As d'/v0 in the impact laws counts at most this.
  static constexpr double largest_rebound_ratio = 100.0;

 private:
  struct Listed {
    RegimeChange gap;
    bool approached;
  };
  struct Ongoing {
    RegimeChange gap;
    std::size_t impact;
    PeakTrackers peaks{3};                      // of indentation, force and friction
    double dissipated_before, friction_before;  // J
    int departures_before = 0;                  // how often the corner had left its edge in contact

    void archive(auto& archive) { archive(gap, impact, peaks, dissipated_before, friction_before, departures_before); }
  };

  void follow(const StepView& view, bool after_event);
  void open(const StepView& view, RegimeChange gap, bool closed_at_start = false);
  void close(const StepView& view, const Ongoing& contact, double time, double rate, bool separated);

  bool with_energies_;
  std::vector<Impact> impacts_;
  std::vector<Listed> listed_;  // the gaps of the impacts
  std::vector<Ongoing> ongoing_;
};

}  // namespace moat
