// The report of the studies of a script.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/provenance.hpp"
#include "study/result.hpp"

namespace moat {

/// A study and its name.
struct NamedStudy {
  std::string name;
  StudyResult result;
};

/// A picture that answers the question of a study, as SVG.
struct StudyPicture {
  std::string title;
  std::string svg;
};

struct StudyReport {
  std::string title;
  Provenance provenance{};
  std::vector<std::string> answers{};  ///< sentences
  std::vector<StudyPicture> pictures{};
  std::vector<NamedStudy> studies{};
};

/// Writes report.html: answers, pictures, then cases, failures, curves and maps of every study; and every answer
/// picture beside it as answer_1.svg, answer_2.svg ... for papers. Throws FileError.
void write_study_report(const StudyReport& report, const std::filesystem::path& folder);

}  // namespace moat
