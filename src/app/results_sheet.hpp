// The essence of a folder of results, as the command `moat report` shows it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"
#include "study/file/store.hpp"

namespace moat {

/// The contents of a folder of results: one run, or studies.
struct ResultsSheet {
  std::filesystem::path folder;
  std::filesystem::path page;  ///< report.html; empty if there is none
  /// The content of summary.json, for a run. `peaks` has the largest of each quantity, `clearances` the smallest.
  std::optional<CaseResult> run{};
  std::size_t impacts = 0;
  /// The files *.db, by name.
  std::vector<std::pair<std::string, StoredStudy>> studies{};
};

/// Throws FileError for a folder that does not exist, that holds no results, or whose summary.json is not one.
ResultsSheet read_results(const std::filesystem::path& folder);

/// For the terminal.
std::string text_of(const ResultsSheet& sheet);

/// For programs, numbers in SI units; the whole is in summary.json.
std::string json_of(const ResultsSheet& sheet);

}  // namespace moat
