// Hot loops that do nothing else for a while, to be watched by a profiler.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// The history that "moat adaptive" is judged by, with default options, over and over: GBZ000, or the pulse where there
/// are no records.
void profile_building(const Options& options);

/// The same exactly between events.
void profile_exact(const Options& options);

/// Steps of a street of 1e5 degrees of freedom.
void profile_street();

/// Watches all of them by perf, where it is installed, and tells where the time goes.
void profile(Record& record, const Options& options);

}  // namespace moat::performance
