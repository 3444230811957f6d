// Progress of an analysis on a terminal or in a log.
#pragma once

#include <chrono>
#include <string>

#include "output/step_observer.hpp"

namespace moat {

/// On a terminal a bar that redraws itself; otherwise one line for every 10 %. To standard error.
class ProgressDisplay final : public StepObserver {
 public:
  /// end: s, the time at which the analysis ends. The label, if any, stands before everything shown.
  explicit ProgressDisplay(double end, std::string label = "");

  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView&, std::span<const RegimeChange>) override {}
  void finish(const StepView& view) override;

 private:
  void show(double time);

  double end_;
  std::string label_;
  bool terminal_;
  int shown_tenths_ = 0;
  int steps_until_look_ = 0;
  std::chrono::steady_clock::time_point last_shown_;
};

}  // namespace moat
