// The parts of a Script. Included by .cpp files alone.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "app/json_output.hpp"
#include "app/script/script.hpp"
#include "app/script/script_origin.hpp"
#include "app/script/script_study.hpp"
#include "app/script/stop_signals.hpp"
#include "design/design_sheet.hpp"
#include "study/ranks/ranks.hpp"

namespace moat {

inline constexpr int exit_error = 1, exit_usage = 2, exit_no_convergence = 3;

struct Script::Parts {
  Parts(int argc, char** argv, std::string title) : line{argc, argv, std::move(title)} {}

  CommandLine line;
  // Found at once, so that a source that is edited during the run is not taken for the one that runs.
  Provenance origin = origin_of_script(line.arguments());
  std::vector<StepObserver*> observers{};
  bool checked = false;  // the whole line
  Ranks* ranks = nullptr;
  std::optional<StopSignals> signals_of_ranks{};
  [[nodiscard]] bool speaks() const { return ranks == nullptr || ranks->rank() == 0; }
  std::optional<JsonOutput> json{};  // with --json
  std::optional<ScriptStudy> study{};
  std::vector<DesignSheet> sheets{};
};

}  // namespace moat
