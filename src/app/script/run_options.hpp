// The options of Script::run().
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "analyses/case/case_run.hpp"
#include "app/script/script.hpp"

namespace moat {

/// The wishes of the command line for a single run.
struct Script::RunOptions {
  std::filesystem::path folder{};                    ///< For the results: --out.
  bool force = false;                                ///< Replaces results in that folder.
  bool resume = false;                               ///< Goes on from the checkpoint in that folder.
  bool quiet = false;                                ///< Prints warnings and errors only.
  bool check = false;                                ///< Error bars for a run of any size.
  bool sensitivity = false, no_sensitivity = false;  ///< Runs with changed contacts: for any size, or never.
  TransientOptions transient{};                      ///< Step, tolerance, integrator and end.
  Time frame_interval{};                             ///< Between VTK frames; 0 writes none.
  Time checkpoint{};                                 ///< Between checkpoints; 0 writes none.

  /// Options of runs on which no number depends.
  inline static const std::set<std::string> without_influence{"out", "force", "checkpoint", "resume", "quiet", "json"};

  /// When runs with changed contacts are made.
  [[nodiscard]] ContactSensitivityMode contact_sensitivity() const {
    return sensitivity      ? ContactSensitivityMode::always
           : no_sensitivity ? ContactSensitivityMode::never
                            : ContactSensitivityMode::automatic;
  }
};

}  // namespace moat
