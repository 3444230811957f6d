// Everything a script leaves behind: files, and lines on the terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "output/case_result.hpp"

namespace moat {

/// Called when so many of `all` parts of the results are written, with the name of the last one.
using WritingProgress = std::function<void(double done, double all, const std::string& written)>;

/// Writes summary.json, histories.csv, histories.vtt, impacts.csv, charts.svg, single charts and report.html into the
/// folder. Throws FileError where a file cannot be written.
void write_results(const CaseResult& result, const std::filesystem::path& folder, const WritingProgress& progress = {});

/// Periods, peaks, clearances, energy, number of impacts and cost, for the terminal.
std::string terminal_summary(const CaseResult& result);

}  // namespace moat
