// Charts of force over indentation of impacts.
#pragma once

#include <vector>

#include "output/case_result.hpp"
#include "output/chart.hpp"

namespace moat {

/// Impacts with a chart at most.
inline constexpr std::size_t most_impact_loops = 12;

/// A chart for every impact, in order of time; of more than `most_impact_loops` those with the largest forces. The
/// title names gap and time.
std::vector<Chart> impact_loops(const std::vector<Impact>& impacts);

}  // namespace moat
