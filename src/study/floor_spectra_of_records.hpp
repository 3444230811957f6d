// Floor spectra of a study, over its records.
#pragma once

#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/table.hpp"
#include "study/statistics.hpp"

namespace moat {

/// A chart for every floor, direction and damping whose spectra the study has as results (StudyOptions::floor_spectra):
/// mean, 84 % and largest of the records, of the envelope where there is one. Infinite values are not drawn. list:
/// statistics_over() the records.
std::vector<Chart> floor_spectra_over_records(const std::vector<RecordStatistics>& list);

/// Returns the numbers for files: a row for every floor, place ("centre", "corner 2"), direction ("x" on a line),
/// damping (share of critical), group (as in table_of(), the envelope among them) and period. Each has mean, 84 %,
/// largest and design value of the pseudo-acceleration, m/s^2. No rows without spectra.
Table floor_spectra_table(const std::vector<RecordStatistics>& list);

}  // namespace moat
