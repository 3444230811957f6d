// The table of impacts and their loops.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat::html {

/// Rows that are shown; impacts.csv has all.
inline constexpr std::size_t most_impacts = 100;

/// The table, a sentence on each of its columns, and the loops (impact_loops()), each with the
/// restitution that its law asks for and the one that it delivered.
std::string impact_section(const CaseResult& result, const std::vector<Chart>& loops);

}  // namespace moat::html
