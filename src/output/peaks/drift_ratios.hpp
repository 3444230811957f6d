// Drift in percent of the height of its storey.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// Returns a peak `drift_ratio` [%] for every peak `drift` [m] of a storey, and in plan `corner_drift_ratio` and so on:
/// 100 drift/height, with its error, time and side. The height is that between the floors of the storey; storeys
/// whose floors have no different heights have no ratio.
std::vector<Peak> drift_ratios(const Model& model, const std::vector<Peak>& peaks);

}  // namespace moat
