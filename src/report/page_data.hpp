// The numbers that the script of a report reads.
#pragma once

#include <string>

#include "output/files/case_result.hpp"

namespace moat::html {

/// JSON with five significant digits:
///
///     {"start": s, "interval": s, "rows": n,
///      "motions": [[m, ...] or null, ...],        one for every node, null where it does not move
///      "charts": [{"title": "", "label": "", "second": {"symbol": "g", "factor": 0.102} or left out, "series":
///      [{"name": "", "colour": "#0072b2", "values": []}]}], "impacts": [{"where": "", "start": s, "end": s}]}
///
/// The charts are history_charts(), with rows at constant intervals, most_rows_of_charts at most. Empty for less than
/// two rows.
std::string page_data(const CaseResult& result);

}  // namespace moat::html
