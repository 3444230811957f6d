// Clocks, and the spread of times.
#pragma once

#include <vector>

#include "measuring/record.hpp"

namespace moat::performance {

enum class Clock {
  thread,  ///< CPU time of the calling thread
  wall,
};

/// Seconds of a clock, from an arbitrary origin.
double seconds(Clock clock = Clock::thread);

/// Peak of the resident memory of this process, bytes.
double peak_resident_bytes();

/// Median and quartiles of at least one value.
Spread spread_of(std::vector<double> values);

/// Median and quartiles of the ratios a/b, round by round. Both hold the same number of rounds, at least one.
Spread ratio_of(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace moat::performance
