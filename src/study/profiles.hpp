// Peaks over the height of buildings, for all records of a study.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"
#include "study/result.hpp"

namespace moat {

/// A chart for each of floor_profiles() (report/charts/result_charts.hpp) and each building: a thin curve for every
/// record, the mean and the 84 % fractile. Of several combinations of the other axes that with the most records that
/// collapsed, among equals that with the largest mean of the others, named in the title. A record that collapsed has no
/// curve, unless all did, and counts as infinite: where the mean is, the chart has the median in its place, and curves
/// that are infinite are not drawn; the legend says so. Cases without result do not count; the legend names them too.
/// None for a study without an axis of at least two records. like: model and buildings of any of its cases.
std::vector<Chart> profiles_over_records(const StudyResult& study, CaseResult like);

}  // namespace moat
