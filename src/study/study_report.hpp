// The report of the studies of a script.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/charts/chart.hpp"
#include "output/files/provenance.hpp"
#include "output/files/table.hpp"
#include "study/result.hpp"
#include "study/statistics.hpp"

namespace moat {

/// A picture that answers a question, as SVG.
struct StudyPicture {
  std::string title;  ///< in words
  std::string svg;    ///< a whole file
  Table numbers{};    ///< of its curves; may be empty
};

/// A table of a script.
struct StudyTable {
  std::string title;  ///< in words
  Table table;        ///< in SI units; shown in the units that engineers read
};

/// A study, its name, and the answers that its results give by themselves.
struct NamedStudy {
  std::string name;                      ///< of its file
  StudyResult result;                    ///< of its cases
  std::vector<std::string> answers{};    ///< sentences
  std::vector<StudyPicture> pictures{};  ///< by the study itself
  std::vector<Chart> profiles{};         ///< of its models (study/profiles.hpp), and loops of isolators
  /// statistics_over() its records; empty without them.
  std::vector<RecordStatistics> statistics{};
};

/// All that the report of studies shows.
struct StudyReport {
  std::string title;                   ///< of the script
  Provenance provenance{};             ///< where the numbers come from
  std::vector<std::string> records{};  ///< which files of folders were left out or paired, and why
  std::vector<std::string> answers{};  ///< of the script, sentences
  /// Pictures of the script. A picture of a study with the title of one of these is left out.
  std::vector<StudyPicture> pictures{};
  std::vector<StudyTable> tables{};   ///< of the script
  std::vector<NamedStudy> studies{};  ///< in the order of the script
};

/// Writes report.html: answers, tables and pictures of the script, then of every study its answers, the statistics over
/// its records, pictures, profiles, maps and curves (pounding first), cases without results, and states. Every picture
/// is a file of its own too, for papers: pictures/study_impacts_over_gap.svg, with the numbers of its curves beside it
/// as CSV, and both are replaced together; every table of the script is one in the folder. A picture of another keeps
/// its name, and the new one gets a number. Throws FileError, and as require_own(); for a table as write_own_csv(),
/// when everything else is written.
void write_study_report(const StudyReport& report, const std::filesystem::path& folder);

/// Throws InputError where something is at the path that no study of moat has put there. Such is a file without the
/// words by which its reports, tables and pictures are known, a link, a file in the place of the folder of pictures.
void require_own(const std::filesystem::path& path);

/// Throws InputError where a file is at the path whose first line does not begin with this heading.
void require_own_table(const std::filesystem::path& path, std::string_view heading);
/// Writes a table as CSV. Throws as require_own_table().
void write_own_csv(const Table& table, const std::filesystem::path& path);

/// Calls all functions, and then throws the first exception of theirs again: one file that cannot be written takes no
/// other with it.
void write_all(std::span<const std::function<void()>> files);

}  // namespace moat
