// Times that can be compared on a machine that is not quiet: candidates take turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measuring/record.hpp"

namespace moat::performance {

enum class Clock {
  thread,  ///< CPU time of the calling thread
  wall,
};

/// Seconds of a clock, from an arbitrary origin.
double seconds(Clock clock = Clock::thread);

struct Candidate {
  std::string name;
  std::function<void()> run;
};

/// Runs A B C A B C ..., `rounds` >= 1 rounds after one to warm up, and returns for each candidate the times of its
/// rounds, s. A change of the machine's speed then affects all candidates, and has little effect on ratios within a
/// round.
std::vector<std::vector<double>> interleaved_times(const std::vector<Candidate>& candidates, int rounds,
                                                   Clock clock = Clock::thread);

/// Median and quartiles of at least one value.
Spread spread_of(std::vector<double> values);

/// Median and quartiles of the ratios a/b, round by round. Both hold the same number of rounds, at least one.
Spread ratio_of(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace moat::performance
