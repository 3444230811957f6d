// The charts that tell a run at a glance.
#pragma once

#include <optional>
#include <vector>

#include "output/case_result.hpp"
#include "output/chart.hpp"

namespace moat {

/// Displacement and absolute acceleration of base and top, and all impact forces, over time: those of them whose
/// columns `result.histories` holds. The base is the first column at a place that is or ends with "base", the top
/// the last column of the quantity. Throws InputError where columns differ in length.
std::vector<Chart> history_charts(const CaseResult& result);

/// The first isolator's force over the displacement of the base; none where a column is missing.
std::optional<Chart> hysteresis_chart(const CaseResult& result);

}  // namespace moat
