// Charts of the largest responses over the height of buildings.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// A chart for each quantity that the floors or storeys of a building have peaks of: displacement, drift, absolute
/// acceleration and storey shear; in plan their resultants, the drift at the corners. A curve for each of up to three
/// buildings of at least two levels, over the height of the floors; values of storeys stand at their middle. Where the
/// nodes have no heights, levels count from 0.
std::vector<Chart> floor_profiles(const CaseResult& result);

}  // namespace moat
