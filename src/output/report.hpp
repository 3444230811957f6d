// The result of a run as one page to read.
#pragma once

#include <filesystem>

#include "output/case_result.hpp"

namespace moat {

/// Writes `folder`/report.html: title, warnings, motion, periods, peaks, clearances, impacts, charts, energy, model,
/// origin, solver statistics and assumptions, in one file that needs nothing else, no network and no script.
///
/// Charts are drawn of columns of `result.histories` over `time`, found by quantity and place:
/// - `displacement` and `absolute_acceleration` of base and top of up to three buildings (output/result_charts.hpp);
/// - `impact_force`: every column;
/// - `isolator_force` of the first isolated building over the displacement of its base;
/// - every quantity that recorders of the script offered (`result.offered`).
/// A chart whose columns are missing is left out. Throws InputError where columns differ in length or hold a value
/// that is not finite, FileError where the file cannot be written.
void write_report_html(const CaseResult& result, const std::filesystem::path& folder);

}  // namespace moat
