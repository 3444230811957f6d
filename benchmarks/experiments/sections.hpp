// The parts of ./moat bench experiments: each compares one experiment, and returns Markdown.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "base/text/number_format.hpp"

namespace moat::experiments {

/// A folder of data, which may lack some experiments, and a folder for files of results.
struct Folders {
  std::filesystem::path data, out;
};

/// Shake-table tests of a building on friction pendulums: folder `buffalo`. Draws a picture for every isolated test.
std::string buffalo(const Folders& folders);
/// Oblique impacts of a sphere: folder `kharaz`.
std::string kharaz(const Folders& folders);
/// An isolated building whose storeys yield, under the record in `smart_base_isolated`; beside OpenSees where that is
/// installed.
std::string yielding_building(const Folders& folders);
/// The benchmark building of eight storeys: folder `smart_base_isolated`.
std::string benchmark_building(const Folders& folders);

/// to_fixed() without a sign before 0.
inline std::string rounded(double value, int decimals) {
  return to_fixed(std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value, decimals);
}
/// A line of a Markdown table.
inline std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}
/// Its first two lines.
inline std::string heading(const std::vector<std::string>& cells) {
  return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

}  // namespace moat::experiments
