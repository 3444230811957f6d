// The five-storey building computed by GNU Octave, when it is installed.
#pragma once

#include <string>

#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

bool octave_is_installed();

struct OctaveRun {
  Peaks peaks{};
  double seconds = 0.0;  ///< CPU time of the integration, by Octave's own clock
};

/// solver: "ode45" or "ode23s". Throws Error if Octave fails.
OctaveRun octave_run(const GroundMotion& motion, const std::string& solver, double relative_tolerance);

}  // namespace moat::performance
