// The files behind a motion, and its hash.
#pragma once

#include <string>
#include <vector>

#include "base/files_read.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// The files of all components, each once.
std::vector<FileRead> files_of(const GroundMotion& motion);

/// The SHA-256 of the files and of the samples of a motion, because files say nothing of scale and filters.
std::string hash_of(const GroundMotion& motion);

}  // namespace moat
