// The five-storey building computed by GNU Octave, when it is installed.
#pragma once

#include <filesystem>
#include <optional>

#include "measuring/five_peaks.hpp"
#include "motions/ground_motion.hpp"

namespace moat::performance {

struct OctaveRun {
  Peaks peaks{};
  double seconds = 0.0;  ///< CPU time of ode45, by Octave's own clock
};

/// By octave/five_storeys.m; nothing if octave-cli is not installed. Octave's input and messages are kept in `folder`.
/// Throws Error if Octave fails.
std::optional<OctaveRun> octave_run(const GroundMotion& motion, const std::filesystem::path& folder);

}  // namespace moat::performance
