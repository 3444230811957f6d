// Peaks over the height of buildings, for all records of a study.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/case_result.hpp"
#include "study/result.hpp"

namespace moat {

/// A chart for each of floor_profiles() (report/charts/result_charts.hpp) and each building: a thin curve for every
/// record, the mean and the 84 % fractile. Of several combinations of the other axes that with the largest mean, named
/// in the title. Cases that collapsed are left out; the legend says so. None for a study without an axis of at least
/// two records. like: model and buildings of any of its cases.
std::vector<Chart> profiles_over_records(const StudyResult& study, CaseResult like);

/// A chart for every floor, direction and damping whose spectra the study has as results (StudyOptions::floor_spectra):
/// mean, 84 % and largest of the records, of the envelope where there is one. Infinite values are not drawn.
std::vector<Chart> floor_spectra_over_records(const StudyResult& study);

}  // namespace moat
