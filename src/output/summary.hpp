// The result of a run in short: for programs (JSON) and for the terminal.
#pragma once

#include <filesystem>
#include <string>

#include "output/case_result.hpp"

namespace moat {

/// Writes summary.json, all numbers in SI units, a value that is not finite as null:
///
///     { "title", "moat_version",
///       "motion": { "name", "peak_acceleration", "peak_velocity", "time_step", "duration" },
///       "periods": [ { "name", "value" } ], "assumptions": [ ... ],
///       "peaks": [ { "quantity", "where", "value", "unit", "time", "error": estimated, same unit, null if not known }
///       ], "error_bars": { "checked", "method", "companion", "companion_impacts",
///                       "companion_solver": { the fields of SolverStatistics }, "sensitive", "reason",
///                       "unsettled": [ { "quantity", "where" } ] }, three of them null if not checked,
///       "impacts": number of impacts,
///       "impact_table": [ { "where", "start", "duration", "approach_speed", "largest_indentation", "largest_force",
///                           "rebound_ratio", "restitution", "energy_lost" } ],
///       "energy": { "unit": "J", the fields of EnergyBalance }, "warnings": [ ... ],
///       "solver": { the fields of SolverStatistics } }
///
/// Throws FileError where the file cannot be written.
void write_summary_json(const CaseResult& result, const std::filesystem::path& path);

/// The peaks as a table of text, grouped by quantity in engineering units, each with its unit, its error where that is
/// known ("53.28 +- 0.02") and the time it was reached. Empty without peaks.
std::string peak_table(const CaseResult& result);

}  // namespace moat
