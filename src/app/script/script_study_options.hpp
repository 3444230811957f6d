// Options of a script with studies.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/command_line.hpp"

namespace moat {

struct ScriptStudyOptions {
  /// Adds the options to the line and reads them. Throws InputError for a text that cannot be.
  explicit ScriptStudyOptions(CommandLine& line);

  std::filesystem::path folder;
  int threads = 0;
  bool quiet = false, retry = false, accept_changes = false;
  /// The cases of --case or --cases; an end beyond the last case means the last.
  std::optional<std::pair<std::size_t, std::size_t>> part{};

  /// Options of studies on which no number depends.
  inline static const std::set<std::string> without_influence{"out",   "threads", "retry", "case",
                                                              "cases", "json",    "quiet", "accept-changes"};
};

}  // namespace moat
