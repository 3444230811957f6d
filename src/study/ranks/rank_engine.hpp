// Computes the cases of a study on all ranks of a job.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "study/engine.hpp"
#include "study/ranks/ranks.hpp"

namespace moat {

/// On rank 0: hands the cases with these numbers to all ranks, one after the other as they end, computes itself on
/// `threads` >= 1 threads beside the one that calls it, and calls finished() for every case. Stops as
/// compute_on_threads() does.
void compute_as_first_rank(Ranks& ranks, const StudyCases& cases, const std::vector<std::size_t>& numbers,
                           const ComputeCase& compute, const CaseFinished& finished, const std::function<bool()>& stop,
                           std::size_t threads);

/// On every other rank: computes the cases that rank 0 hands out.
void compute_as_other_rank(Ranks& ranks, const StudyCases& cases, const ComputeCase& compute);

}  // namespace moat
