// The result of a run as one page to read.
#pragma once

#include <filesystem>

#include "output/files/case_result.hpp"
#include "report/charts/result_charts.hpp"

namespace moat {

/// Writes `folder`/report.html, one file that needs nothing else and no network. It begins with a summary in one
/// screen, warnings, the model drawn to scale and moved by the histories, and histories that zoom together. Then come
/// profiles over height, loops of isolators and impacts, table of impacts, tornado charts of contact parameters,
/// energies, floor response spectra, peaks, clearances and periods. Folded are motion, model, origin, solver and
/// assumptions.
///
/// Without JavaScript the drawing is at rest and the histories are pictures. They are so too where the package
/// libjs-dygraphs is not installed when the report is written. Models of more than `most_drawn_nodes` nodes have no
/// drawing, and long tables show their most important rows.
///
/// charts: those of the same result. Throws InputError where a chart cannot be drawn, FileError where the file cannot
/// be written.
void write_report_html(const CaseResult& result, const ResultCharts& charts, const std::filesystem::path& folder);

}  // namespace moat
