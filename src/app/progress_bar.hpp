// Progress on a terminal or in a log.
#pragma once

#include <chrono>
#include <string>

#include "output/recorders/step_observer.hpp"
#include "study/engine.hpp"

namespace moat {

/// On a terminal a bar that redraws itself at every percent and is gone at the end; otherwise one line for every 10 %,
/// and none in the first second, so that short runs leave no lines in a log. To standard error.
///
///     run_study(axes, compute, {.progress = ProgressBar{"gaps"}});
class ProgressBar {
 public:
  /// title: stands before everything shown, if not empty. unit: of the amounts that are counted. quiet_time: s, >= 0,
  /// from now on; nothing is written to a log in this time.
  explicit ProgressBar(const std::string& title = "", std::string unit = "cases", double quiet_time = 1.0);

  /// 0 <= done <= all, all > 0. note: shown behind the amount.
  void operator()(double done, double all, const std::string& note = "");
  /// Shows the progress of a study, with rate, remaining time, impacts and failures so far.
  void operator()(const StudyProgress& progress);
  /// Shows the next work from 0 on. The quiet time does not begin again.
  void restart() { shown_percent_ = 0; }
  /// Removes an unfinished bar from the terminal.
  void clear();

 private:
  std::string title_, unit_;
  double quiet_time_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_;
  int shown_percent_ = 0;
};

/// Shows the time that an analysis has reached; of several analyses one after the other.
class ProgressObserver final : public StepObserver {
 public:
  /// end: s, > 0, the time at which the analysis ends.
  explicit ProgressObserver(double end, const std::string& title = "") : end_{end}, bar_{title, "s"} {}

  void start(const StepView&) override { bar_.restart(); }
  void step(const StepView& view) override { bar_(view.state.time(), end_); }
  void event(const StepView&, std::span<const RegimeChange>) override {}
  void finish(const StepView&) override { bar_.clear(); }
  void archive(StateArchive&) override {}

 private:
  double end_;
  ProgressBar bar_;
};

}  // namespace moat
