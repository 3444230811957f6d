// Answers of studies, and their pictures.
#pragma once

#include <string>
#include <vector>

#include "analyses/questions/fragility.hpp"
#include "analyses/questions/incremental_dynamic_analysis.hpp"
#include "output/charts/chart.hpp"
#include "study/study_report.hpp"

namespace moat {

/// The fitted curve with its confidence band, and the shares that were counted. level_label: "Sa(2 s) [g]".
Chart fragility_chart(const LognormalFit& fit, const std::vector<EventCount>& counts, const std::string& title,
                      const std::string& level_label);

/// All curves in light blue, and the responses that 16, 50 and 84 % of the records do not exceed; response over level.
/// A curve ends where the model collapsed. per_unit: value of one unit of the response in SI, 0.01 for cm.
Chart ida_chart(const std::vector<IdaCurve>& curves, const std::string& title, const std::string& level_label,
                const std::string& response_label, double per_unit = 1.0);
/// Draws the response in this unit, for example 1 * cm.
template <class Q>
requires requires { Q::mass_exponent; }
Chart ida_chart(const std::vector<IdaCurve>& curves, const std::string& title, const std::string& level_label,
                const std::string& response_label, Q per_unit) {
  return ida_chart(curves, title, level_label, response_label, per_unit.si());
}

/// The probability of pounding against the gap, in cm, with its confidence band, and the share of the records that
/// need more, as far as it is known. The legend says how many need more than the largest gap.
Chart pounding_chart(const GapDemand& demand, const std::string& title);

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
