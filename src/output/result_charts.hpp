// The charts that tell a run at a glance.
#pragma once

#include <optional>
#include <vector>

#include "output/case_result.hpp"
#include "output/chart.hpp"

namespace moat {

/// Displacement and absolute acceleration of base and top of up to three buildings, and all impact forces, over time:
/// those of them whose columns `result.histories` holds. Buildings are told by the names that ShearBuilding gives
/// their nodes, "<prefix>base" and "<prefix>floor 1": the top is the last floor of that prefix. Where a building has
/// no such floors it is the last node before the next base whose name has its prefix, moat walls excepted; where no
/// name is known, the last column. Throws InputError where columns differ in length.
std::vector<Chart> history_charts(const CaseResult& result);

/// The isolator force of the first building that has a base over the displacement of that base; none where a column is
/// missing.
std::optional<Chart> hysteresis_chart(const CaseResult& result);

}  // namespace moat
