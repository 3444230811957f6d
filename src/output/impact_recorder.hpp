// The table of impacts.
#pragma once

#include <vector>

#include "output/case_result.hpp"
#include "output/peak_tracker.hpp"
#include "output/step_observer.hpp"

namespace moat {

/// Lists every contact from touch until the gap opens. A contact that still lasts at the end is listed with
/// its duration so far and without a rebound ratio (NaN). What the law alone would have done is filled in at finish().
class ImpactRecorder final : public StepObserver {
 public:
  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange> changes) override;
  void finish(const StepView& view) override;

  /// In order of touch.
  [[nodiscard]] const std::vector<Impact>& impacts() const { return impacts_; }

 private:
  struct Ongoing {
    RegimeChange gap;
    std::size_t impact;
    PeakTracker indentation, force;
    double dissipated_before;
  };

  void follow(const StepView& view, bool after_event);
  void open(const StepView& view, RegimeChange gap);
  void close(const StepView& view, const Ongoing& contact, bool separated);

  std::vector<Impact> impacts_;
  std::vector<RegimeChange> gaps_;  // of the impacts
  std::vector<Ongoing> ongoing_;
};

}  // namespace moat
