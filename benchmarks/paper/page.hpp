// The output of all scripts, as one page for a browser and one for the documentation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::paper {

/// A script of the benchmark and its outcome.
struct ScriptRun {
  std::string id;       ///< its results are in <folder>/<id>.json
  std::string program;  ///< name of the program, and of its source without ending
  std::string failure;  ///< empty unless the program ended without results
};

struct Totals {
  std::size_t asserted = 0, held = 0, reported = 0, skipped = 0;
};

Totals totals_of(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs);

/// Writes <folder>/index.html, with all figures inside. Throws FileError.
void write_page(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs);

/// The tables, checks and findings as Markdown, with headings of third level.
std::string documentation(const std::filesystem::path& folder, const std::vector<ScriptRun>& runs);

}  // namespace moat::paper
