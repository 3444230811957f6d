// Orbits of bases in plan.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// For every base of a model in plan its displacement along y over that along x, at the centre of mass and at every
/// corner of the outline. None on a line and without histories.
std::vector<Chart> orbit_charts(const CaseResult& result);

}  // namespace moat
