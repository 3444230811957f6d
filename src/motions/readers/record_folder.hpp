// All horizontal motions, or all pairs, in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// The horizontal motions in a folder, as they are in the files and in the order of their names. Which channel is
/// horizontal is known as by read_records(); the table records.csv in the folder decides before.
///
/// Throws FileError where nothing says whether a file is horizontal or vertical, for a folder that does not exist or
/// has no horizontal channel, and as read_records().
std::vector<GroundMotion> read_record_folder(const std::filesystem::path& folder);

/// Reads the records of read_records() that have two horizontal components, without the vertical one. Throws FileError
/// where there is none.
std::vector<PlanMotion> read_record_pairs(const std::filesystem::path& folder);

/// A sentence about every file and channel that these functions and read_records() have read in this program: as which
/// component it was taken, or why it was left out. Scripts print them and put them into their results.
std::vector<std::string> record_folder_notes();

}  // namespace moat
