// Times of single functions by Google Benchmark.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "performance/record.hpp"

namespace moat::performance {

struct TimedFunction {
  std::string name;
  std::function<void()> call;
};

/// CPU time of one call of each function, ns, over `repetitions` >= 1.
std::vector<Spread> nanoseconds_per_call(const std::vector<TimedFunction>& functions, int repetitions);

}  // namespace moat::performance
