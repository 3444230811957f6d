// Readers of single formats, by their earlier names. read_motion() knows the format of a file by itself.
#pragma once

#include <filesystem>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// All of them read as read_motion() does.
GroundMotion read_peer_at2(const std::filesystem::path& path);
GroundMotion read_cosmos(const std::filesystem::path& path);                          ///< As read_motion().
GroundMotion read_esm(const std::filesystem::path& path);                             ///< As read_motion().
GroundMotion read_two_columns(const std::filesystem::path& path, Acceleration unit);  ///< As read_motion().

}  // namespace moat
