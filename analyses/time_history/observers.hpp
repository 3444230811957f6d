// The observers of one analysis.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "output/recorders/step_observer.hpp"

namespace moat {

/// Calls observers in the order in which they were added. Each gets the start before anything else, also one that is
/// added while another is called.
class Observers {
 public:
  /// The observer must outlive this object.
  void add(StepObserver& observer);

  /// Starts those that were not started before.
  void start(const StepView& view);
  /// After every committed step.
  void step(const StepView& view) const {
    for_each_started([&](StepObserver& observer) { observer.step(view); });
  }
  /// After every change of regime.
  void event(const StepView& view, std::span<const RegimeChange> changes) const {
    for_each_started([&](StepObserver& observer) { observer.event(view, changes); });
  }
  /// After the last step. All are finished, also if one of them throws; the first exception goes on.
  void finish(const StepView& view) const;
  /// Writes or reads all observers in their order.
  void archive(StateArchive& archive) const {
    for (const Follower& each : followers_) each.observer->archive(archive);
  }

 private:
  struct Follower {
    StepObserver* observer;
    bool started;
  };

  // The list may grow meanwhile.
  template <class Call>
  void for_each_started(const Call& call) const {
    for (std::size_t i = 0; i < followers_.size(); ++i)
      if (followers_[i].started) call(*followers_[i].observer);
  }

  std::vector<Follower> followers_;
};

}  // namespace moat
