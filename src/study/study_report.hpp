// The report of the studies of a script.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/files/provenance.hpp"
#include "study/result.hpp"

namespace moat {

/// A picture that answers a question, as SVG.
struct StudyPicture {
  std::string title;  ///< in words
  std::string svg;    ///< a whole file
};

/// A study, its name, and the answers that its results give by themselves.
struct NamedStudy {
  std::string name;                      ///< of its file
  StudyResult result;                    ///< of its cases
  std::vector<std::string> answers{};    ///< sentences
  std::vector<StudyPicture> pictures{};  ///< by the study itself
};

/// All that the report of studies shows.
struct StudyReport {
  std::string title;                   ///< of the script
  Provenance provenance{};             ///< where the numbers come from
  std::vector<std::string> records{};  ///< which files of folders were left out or paired, and why
  std::vector<std::string> answers{};  ///< of the script, sentences
  /// Pictures of the script. A picture of a study with the title of one of these is left out.
  std::vector<StudyPicture> pictures{};
  std::vector<NamedStudy> studies{};  ///< in the order of the script
};

/// Writes report.html: answers and pictures of the script, then of every study its states, answers, pictures, maps and
/// curves (pounding first), and cases without results. Every picture is a file of its own too, for papers:
/// pictures/study_impacts_over_gap.svg. A picture of another keeps its name, and the new one gets a number. Throws
/// FileError, and as require_own().
void write_study_report(const StudyReport& report, const std::filesystem::path& folder);

/// Throws InputError where something is at the path that no study of moat has put there: a file without the words by
/// which its reports, tables and pictures are known, a link, a file in the place of the folder of pictures.
void require_own(const std::filesystem::path& path);

}  // namespace moat
