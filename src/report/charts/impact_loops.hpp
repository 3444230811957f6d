// Charts of force over indentation of impacts.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Impacts with a chart at most.
inline constexpr std::size_t most_impact_loops = 12;

/// The name of an impact: "2.659 s, moat left". The time comes first, so that a shortened title keeps it.
std::string title_of(const Impact& impact);

/// A chart for every impact, in order of time; of more than `most_impact_loops` those with the largest forces.
std::vector<Chart> impact_loops(const std::vector<Impact>& impacts);

}  // namespace moat
