// All records in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// The horizontal motions in the `.AT2` files of a folder, in the order of their names. Whether a file is vertical is
/// known from the end of the second line of a PEER header (KJMA, 90), else from the end of its name: a word behind -, _
/// or a blank (-UP, -DWN, -V, -N, -EW), an azimuth of three digits, or UP behind a digit or capital. A table in the
/// folder, records.csv, decides before both, and may name files of all formats:
///
///     file,record,component
///     a.AT2,Kobe,first              components: first, second, vertical, out
///
/// Throws FileError where none of them decides, for a folder that does not exist or has no horizontal file, a row of
/// the table that is not of this form, and as read_motion().
std::vector<GroundMotion> read_record_folder(const std::filesystem::path& folder);

/// Those motions of which the folder has two components, at an incidence of 0: files whose headers, names or rows of
/// the table differ in the component alone. The first is first by name, or by the table. Records with one component are
/// left out. Throws as read_record_folder(), where there is no pair, and where a record has three components or two
/// that are not at right angles within 30 degrees.
std::vector<PlanMotion> read_record_pairs(const std::filesystem::path& folder);

/// Where the file of a motion says that it is vertical, by a header, also of COSMOS or ESM, or a name as above: "its
/// name says "UP""; empty if it does not.
std::string says_vertical(const GroundMotion& motion);

/// Every file that these functions have left out, and every pair that they have made in this program, with the reason.
/// Scripts print them and put them into their results.
std::vector<std::string> record_folder_notes();

}  // namespace moat
