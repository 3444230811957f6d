// Pictures of a study.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/charts/heat_map.hpp"
#include "study/result.hpp"

namespace moat {

/// The value that a share, from 0 to 1, of the values does not exceed, with linear interpolation; infinite where one of
/// its neighbours is. NaN without values.
double fractile(std::vector<double> values, double share);

/// For every axis of at least three numbers, a chart of each quantity over it: the largest value of all places (of
/// clearances the smallest). There is a curve for each combination of the other axes, or their median with the band
/// from 16 to 84 % where there are more than seven. Quantities of pounding come first. Errors and energies are left
/// out, and of many quantities all but the first eight. A case that collapsed counts as infinite, except in quantities
/// of pounding; infinite values are not drawn.
std::vector<Chart> axis_charts(const StudyResult& study);

/// For two axes of at least three numbers each, a map of each of those quantities: the median over the other axes.
std::vector<HeatMap> heat_maps(const StudyResult& study);

}  // namespace moat
