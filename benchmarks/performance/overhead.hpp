// What the general path costs beside a loop written for one building.
#pragma once

#include "performance/options.hpp"
#include "performance/record.hpp"

namespace moat::performance {

/// Cost per accepted step of CaseRun against bare_history(), where the time goes, and heap requests per step.
void overhead(Record& record, const Options& options);

}  // namespace moat::performance
