// The run behind the main run of a case that is computed now.
#pragma once

#include <string>

#include "analyses/time_history/transient.hpp"
#include "base/state_archive.hpp"

namespace moat {

/// A run of compute_peaks() (analyses/case/error_bars.hpp) until its end, for checkpoints.
class RunUnderWay {
 public:
  /// The run begins, with all its observers: it goes on from the state that archive() read, if there is one.
  void begin(Transient& transient);
  /// The run has ended.
  void end() { transient_ = nullptr; }
  /// Writes the state of the run, or reads it for begin().
  void archive(StateArchive& archive);

 private:
  Transient* transient_ = nullptr;
  std::string state_;  // for begin()
};

}  // namespace moat
