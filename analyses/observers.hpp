// The observers of one analysis.
#pragma once

#include <exception>
#include <span>
#include <vector>

#include "output/step_observer.hpp"

namespace moat {

/// Calls observers in the order in which they were added. Each gets the start before its first step.
class Observers {
 public:
  /// The observer must outlive this object.
  void add(StepObserver& observer) { followers_.push_back({&observer, false}); }

  /// Starts those that were not started before.
  void start(const StepView& view) {
    for (Follower& follower : followers_) {
      if (follower.started) continue;
      follower.started = true;
      follower.observer->start(view);
    }
  }
  /// After every committed step.
  void step(const StepView& view) const {
    for (const Follower& follower : followers_) follower.observer->step(view);
  }
  /// After every change of regime.
  void event(const StepView& view, std::span<const RegimeChange> changes) const {
    for (const Follower& follower : followers_) follower.observer->event(view, changes);
  }
  /// After the last step. All are finished, also if one of them throws; the first exception goes on.
  void finish(const StepView& view) const {
    std::exception_ptr failure;
    for (const Follower& follower : followers_) {
      try {
        follower.observer->finish(view);
      } catch (...) {
        if (!failure) failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
  }

 private:
  struct Follower {
    StepObserver* observer;
    bool started;
  };
  std::vector<Follower> followers_;
};

}  // namespace moat
