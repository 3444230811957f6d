// Everything a script leaves behind: files, and lines on the terminal.
#pragma once

#include <filesystem>
#include <string>

#include "output/case_result.hpp"

namespace moat {

/// Writes summary.json, histories.csv, histories.vtt, impacts.csv, charts.svg and report.html into the folder.
/// Throws FileError where a file cannot be written.
void write_results(const CaseResult& result, const std::filesystem::path& folder);

/// Periods, peaks, clearances, energy, number of impacts and cost, for the terminal.
std::string terminal_summary(const CaseResult& result);

}  // namespace moat
