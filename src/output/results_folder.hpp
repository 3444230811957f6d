// The folder a run writes into, and the names of the files in it.
#pragma once

#include <filesystem>

namespace moat {

/// What moat writes into a results folder. Overwriting deletes these and nothing else, so a new kind of file belongs
/// in this list.
namespace results_file {
inline constexpr const char* summary = "summary.json";
inline constexpr const char* histories_csv = "histories.csv";
inline constexpr const char* histories_vtt = "histories.vtt";
inline constexpr const char* impacts = "impacts.csv";
inline constexpr const char* report = "report.html";
inline constexpr const char* charts = "charts.svg";
inline constexpr const char* frames = "frames.pvd";
/// Sub-folder of the frames frame_000000.vtu, frame_000001.vtu ...
inline constexpr const char* frames_folder = "frames";
}  // namespace results_file

/// What to do when the wanted folder already holds something.
enum class WhenFolderExists {
  use_new_number,  ///< write to the next free of results_2, results_3 ...
  /// Delete the files moat itself wrote there, and links that have their names; everything else stays. Throws
  /// InputError where files have the names of results and there is no summary.json of moat.
  overwrite,
  refuse  ///< throw InputError
};

/// Creates the folder (and those above it) and returns where to write. A folder that exists but is empty is taken as
/// it is; one given as . or .. has its own name. Throws InputError for an empty path, the root and for `refuse`,
/// FileError where a folder cannot be created or emptied (among others because a file of that name exists).
std::filesystem::path make_results_folder(std::filesystem::path wanted, WhenFolderExists when_exists);

/// Whether a file was, by its name relative to a results folder, written by moat.
bool is_results_file(const std::filesystem::path& relative_path);

}  // namespace moat
