// Where a result comes from.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace moat {

/// Enough to compute a result again. Texts that are not known are empty.
struct Provenance {
  /// It may be given to a shell again: "moat run tower.cpp --gap '12 cm'".
  std::string command_line{};
  std::string script{};         ///< absolute path of the source; of the program, where the source is not known
  std::string script_sha256{};  ///< of the source; empty where that is not known
  /// Every option of the script with its value, also those left at their defaults.
  std::vector<std::pair<std::string, std::string>> options{};
  std::string moat_version{};  ///< "0.1.0"
  /// Commit of the source that moat was built from: 40 digits, "-dirty" behind them if files had been changed.
  std::string git_commit{};
  std::string date{};  ///< when the result was made, UTC: "2026-01-31T12:00:00Z"
};

/// Version, commit and date; the rest is left empty.
Provenance provenance_of_library();

}  // namespace moat
