// The five-storey building computed by GNU Octave, when it is installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

bool octave_is_installed();

struct OctaveSetting {
  std::string solver;  ///< "ode45" or "ode23s"
  double relative_tolerance = 1e-3;
  double intervals_per_step = 1.0;  ///< > 0, at most
};

struct OctaveRun {
  Peaks peaks{};
  double seconds = 0.0;  ///< CPU time of the integration, by Octave's own clock
};

/// Empty if Octave fails; what it says to its error stream, also of warnings, is added to the file `messages`.
std::optional<OctaveRun> octave_run(const GroundMotion& motion, const OctaveSetting& setting,
                                    const std::filesystem::path& messages);

}  // namespace moat::performance
