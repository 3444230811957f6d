// Progress of a parameter study on a terminal or in a log.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace moat {

/// On a terminal a bar that redraws itself; otherwise one line for every 10 %. To standard error.
///
///     run_study(axes, compute, {.progress = StudyProgress{"gap size"}});
class StudyProgress {
 public:
  /// title: what is being computed, put before the bar.
  explicit StudyProgress(std::string title);

  /// Called after every case.
  void operator()(std::size_t done, std::size_t all);

 private:
  std::string title_;
  bool terminal_;
  std::size_t shown_tenths_ = 0;
  std::chrono::steady_clock::time_point started_, last_shown_;
};

}  // namespace moat
