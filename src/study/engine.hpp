// Computes the cases of a study on all cores.
#pragma once

#include <cstddef>
#include <functional>
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

/// Computes the cases with these numbers. Every worker computes one case after the other in a thread of its own, the
/// first one in that of the caller; where the system gives fewer threads, those compute all cases. stop, which may be
/// empty, is asked before every case, by one thread at a time: true lets cases in flight end, and hands out no more. An
/// exception of finished() (a full disk) ends the study in the same way and is thrown again.
void compute_cases(const StudyCases& cases, const std::vector<std::size_t>& numbers,
                   const std::vector<ComputeCase>& workers, const CaseFinished& finished,
                   const std::function<bool()>& stop);

}  // namespace moat
