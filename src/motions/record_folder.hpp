// All records in a folder.
#pragma once

#include <filesystem>
#include <vector>

#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// The horizontal motions in the `.AT2` files of a folder, in the order of their names. Files whose name ends in -UP,
/// -DWN, -VER or -V, or in UP behind a digit or capital, are vertical and left out. Throws FileError for a folder that
/// does not exist or has no such file, and as read_peer_at2().
std::vector<GroundMotion> read_record_folder(const std::filesystem::path& folder);

/// Those motions of which the folder has two components, at an incidence of 0: files whose names differ only in their
/// last word of digits (an azimuth: NWH090, NWH360) or of one letter (TCU068-E, TCU068-N). The first is first by name.
/// Records with one component are left out. Throws as read_record_folder(), where there is no pair, and where a record
/// has three.
std::vector<PlanMotion> read_record_pairs(const std::filesystem::path& folder);

}  // namespace moat
