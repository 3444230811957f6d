// The charts that show a run at a glance.
#pragma once

#include <optional>
#include <vector>

#include "output/case_result.hpp"
#include "output/chart.hpp"

namespace moat {

/// Displacement and absolute acceleration of base and top of up to three buildings, and all impact forces, over time:
/// those of them whose columns `result.histories` holds. The last node where the model has no building. Then a chart
/// for every quantity that recorders offered. Throws InputError where columns differ in length.
std::vector<Chart> history_charts(const CaseResult& result);

/// The isolator force of the first isolated building over the displacement of its base; none where a column is
/// missing.
std::optional<Chart> hysteresis_chart(const CaseResult& result);

}  // namespace moat
