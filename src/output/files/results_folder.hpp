// The folder a run writes into, and the names of the files in it.
#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace moat {

/// The files that moat writes into a results folder.
namespace results_file {
inline constexpr const char* summary = "summary.json";         ///< Everything in numbers, as JSON.
inline constexpr const char* histories_csv = "histories.csv";  ///< Histories as text.
inline constexpr const char* histories_vtt = "histories.vtt";  ///< Histories for ParaView.
inline constexpr const char* impacts = "impacts.csv";          ///< A row for every impact.
inline constexpr const char* peaks = "peaks.csv";              ///< A row for every peak.
/// A row for every mode of buildings given by matrices or modes.
inline constexpr const char* participating_masses = "participating_masses.csv";
/// A row for every check of a bearing with capacities.
inline constexpr const char* bearing_checks = "bearing_checks.csv";
/// A row for every period of every floor spectrum.
inline constexpr const char* floor_spectra = "floor_spectra.csv";
/// The channels of records, as they were understood.
inline constexpr const char* records = "records_read.csv";
inline constexpr const char* report = "report.html";              ///< The report.
inline constexpr const char* design_sheet = "design_sheet.html";  ///< Design sheets by a code.
inline constexpr const char* charts = "charts.svg";               ///< All histories as pictures.
inline constexpr const char* frames = "frames.pvd";               ///< The frames, for ParaView.
/// Draws the frames in ParaView.
inline constexpr const char* paraview_script = "moat.py";
/// Sub-folder of the frames frame_000000.vtu, frame_000001.vtu ...
inline constexpr const char* frames_folder = "frames";
/// Sub-folder of single charts: displacement.svg, displacement.csv ...
inline constexpr const char* charts_folder = "charts";
/// The state of a run that was killed or stopped, from which --resume goes on.
inline constexpr const char* checkpoint = "checkpoint";
/// Stands in a folder until its results are complete, and names command, host, process and start of the run.
inline constexpr const char* unfinished = "unfinished";
/// Lists the files of complete results. Overwriting replaces these, and nothing else.
inline constexpr const char* list = ".moat";
/// All files and sub-folders of results.
inline constexpr std::array all_names{
    summary,       histories_csv, histories_vtt, impacts,    peaks,  participating_masses, bearing_checks,
    floor_spectra, report,        design_sheet,  charts,     frames, paraview_script,      frames_folder,
    charts_folder, records,       checkpoint,    unfinished, list};
}  // namespace results_file

/// How a folder is treated that already holds something.
enum class WhenFolderExists {
  use_new_number,  ///< write to the next free of results_2, results_3 ...
  /// Replace the files that `.moat` lists, or after a run that was killed all that have the names of results, or lie
  /// in the folders frames and charts. All other files stay; links of such names are removed, not followed. Throws
  /// InputError where there is neither `.moat` nor `unfinished` of moat.
  overwrite,
  /// Go on in folder_with_checkpoint(). The list of files, single charts, and files that were not written to their end
  /// are removed; all others stay. Throws InputError where there is no checkpoint, or another run computes there, and
  /// FileError where the folder cannot be locked.
  go_on
};

/// Returns this folder, or the first of "<name>.new", "<name>.new_2" ... beside it, that has the file `checkpoint`; of
/// a link its target, or those beside that. Throws InputError where none has one.
std::filesystem::path folder_with_checkpoint(const std::filesystem::path& wanted);

/// The folder of one run. It is taken at once: of runs that start together each gets a folder of its own, and a run
/// that is killed leaves the file `unfinished`.
///
/// Results that are to be overwritten stay until the new ones are complete. These are written to the folder
/// "<name>.new" beside, which then gets hard links to the files of the user. Both folders exchange their names in one
/// system call (renameat2); on file systems without it, such as NFS, by three renames. A run that is killed at any
/// moment leaves the old or the new results. The next one that overwrites them gives complete results in "<name>.new"
/// their place, removes the rest, and begins. Results of a run that stopped before its end go to the next free
/// number by finish_incomplete().
///
///     ResultsFolder folder{"results/tower", WhenFolderExists::overwrite};
///     write_results(result, folder.path());
///     folder.finish();
class ResultsFolder {
 public:
  /// Creates the folder and those above it. A folder that exists but is empty is taken as it is; one given as . or ..
  /// has its own name. command: for `unfinished`. Throws InputError for an empty path, the root, and a folder
  /// that may not be overwritten, FileError where a folder cannot be created (among others because a file of that name
  /// exists).
  ResultsFolder(const std::filesystem::path& wanted, WhenFolderExists when_exists,
                const std::string& command = program_invocation_name);
  /// Without finish() before, "<name>.new" stays unfinished, and any other folder where an exception is under way; else
  /// that loses its mark.
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  /// Where to write until finish().
  [[nodiscard]] const std::filesystem::path& path() const { return beside_ ? *beside_ : final_; }
  /// Where the results are after finish().
  [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }

  /// Lists the files in `.moat`, puts them in their place, and removes `unfinished`. Before old results are removed,
  /// and after a run of 10 s, it waits until the new ones are on the disk. Does as finish_incomplete() where another
  /// run writes in that place now, or a file of the user has the name of a new result. Calling it again does nothing.
  /// Throws FileError where the list cannot be written, or a file cannot be moved.
  void finish();
  /// For results of a run that stopped before its end: those that were to be overwritten stay, and the new ones get the
  /// next free of results_2, results_3 ..., which is final_path() then. Returns whether there are such old results;
  /// else, or after finish(), it does nothing. Throws FileError where the folder cannot be moved.
  bool finish_incomplete();

 private:
  void go_on(const std::string& command);
  void make_folder_beside(const std::string& command);

  std::filesystem::path final_;
  std::optional<std::filesystem::path> beside_;  // while there are old results
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int mark_ = -1;  // the file `unfinished`, locked until finish()
};

}  // namespace moat
