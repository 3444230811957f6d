// The answers that the results of a study give by themselves.
#pragma once

#include <string>
#include <vector>

#include "study/result.hpp"
#include "study/study_report.hpp"

namespace moat {

/// Sentences and pictures for the report.
struct StudyAnswers {
  std::vector<std::string> sentences{};  ///< one answer each
  std::vector<StudyPicture> pictures{};  ///< one question each
};

/// Where all axes are of names (records, laws): of smallest gaps "Probability of pounding" against the gap, with the
/// fit and its band; of hunts "Incremental dynamic analysis", and "Fragility" for the limit of the hunt. Where one axis
/// is of numbers and cases have `impacts`: the share of the cases that pounds against this axis, with the bounds of the
/// share. Where a fit does not exist, a sentence says why.
StudyAnswers answers_of(const StudyResult& study);

}  // namespace moat
