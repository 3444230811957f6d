// Warnings about the weight on bearings.
#pragma once

#include <string>
#include <vector>

#include "model/analysis_state.hpp"

namespace moat {

/// Warnings of unstable rubber, rocking, and uplift of bearings that do not slide. Where an analysis ended early they
/// name bearings whose horizontal force follows the axial force so steeply that there may be no balance: the force
/// lifts the bearing further as it falls (the paradox of Painleve).
std::vector<std::string> weight_warnings(const AnalysisState& state, bool ended_early);

}  // namespace moat
