// Computes the cases of a study on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "study/cases.hpp"
#include "study/outcome.hpp"

namespace moat {

/// How far a study is.
struct StudyProgress {
  std::size_t all = 0;       ///< cases
  std::size_t done = 0;      ///< of these, also those of earlier runs
  std::size_t computed = 0;  ///< in this run
  std::size_t failed = 0;    ///< of `done`, those that did not converge included
  double impacts = 0.0;      ///< of all cases with a result "impacts"
  double seconds = 0.0;      ///< since this run began
};

/// Called by one thread at a time with the number of a case and its end.
using CaseFinished = std::function<void(std::size_t number, CaseOutcome&& outcome)>;
/// Computes one case; called from several threads at once.
using ComputeCase = std::function<CaseOutcome(const StudyCase&)>;

/// The outcome of compute(), with its seconds and the files it read; an exception becomes a state with its message, and
/// so do two results with one name, or a result with the name of an axis.
CaseOutcome outcome_of(const StudyCase& each, const ComputeCase& compute);

/// Hands the numbers of open cases to threads, one after the other. Safe to call from several threads.
class OpenCases {
 public:
  /// stop: asked before every case, by one thread at a time; true hands out no more. May be empty.
  OpenCases(std::vector<std::size_t> numbers, std::function<bool()> stop)
      : numbers_{std::move(numbers)}, stop_{std::move(stop)} {}

  /// The next number and true, or false if there is none.
  bool next(std::size_t& number) {
    const std::lock_guard lock{mutex_};
    if (next_ >= numbers_.size() || (stop_ && stop_())) return false;
    number = numbers_[next_++];
    return true;
  }
  /// Hands out no more.
  void close() {
    const std::lock_guard lock{mutex_};
    next_ = numbers_.size();
  }

 private:
  std::vector<std::size_t> numbers_;
  std::function<bool()> stop_;
  std::mutex mutex_;
  std::size_t next_ = 0;
};

/// Computes the cases with these numbers on `threads` >= 1 threads, the caller's among them, until stop() is true:
/// cases in flight end. Where the system gives fewer threads, those compute all cases. An exception of finished() (a
/// full disk) ends the study in the same way and is thrown again.
void compute_on_threads(const StudyCases& cases, const std::vector<std::size_t>& numbers, const ComputeCase& compute,
                        const CaseFinished& finished, const std::function<bool()>& stop, std::size_t threads);

}  // namespace moat
