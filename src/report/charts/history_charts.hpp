// Charts over time.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Buildings of a chart at most, so that it stays legible.
inline constexpr std::size_t most_charted_buildings = 3;

/// Displacement and absolute acceleration of base and top of up to three buildings, and the forces of all gaps that
/// closed, over time: those of them whose columns `result.histories` holds. The last node where the model has no
/// building. Then a chart for every quantity that recorders offered. Throws InputError where columns differ in length.
std::vector<Chart> history_charts(const CaseResult& result);

}  // namespace moat
