// Everything a script leaves behind: files, and lines on the terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "output/files/case_result.hpp"

namespace moat {

/// Called when so many of `all` parts of the results are written, with the name of the last one.
using WritingProgress = std::function<void(double done, double all, const std::string& written)>;

/// Writes histories.csv, histories.vtt, impacts.csv, peaks.csv, bearing_checks.csv, floor_spectra.csv, charts.svg,
/// single charts, report.html, and at last summary.json into the folder: one with a summary is complete. Throws
/// FileError where a file cannot be written, and as vtk_files().
void write_results(const CaseResult& result, const std::filesystem::path& folder, const WritingProgress& progress = {});

/// Where write_results() failed: removes frames and charts, writes the files one by one, the most important ones first,
/// and returns a sentence that names those that are there and those that are not. The checkpoint stays.
std::string keep_results(const CaseResult& result, const std::filesystem::path& folder);

/// The table of buildings, periods, peaks, clearances, energy, number of impacts and cost, for the terminal.
std::string terminal_summary(const CaseResult& result);

}  // namespace moat
