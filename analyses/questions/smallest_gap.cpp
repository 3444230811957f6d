#include "analyses/questions/smallest_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/root.hpp"
#include "base/text/number_format.hpp"

namespace moat {
namespace {

/// One result of all cases that are done and have a finite one, ascending.
std::vector<double> finite_results(const StudyResult& study, std::string_view quantity) {
  std::vector<double> values;
  for (const CaseOutcome& outcome : study.outcomes())
    for (const NamedNumber& result : outcome.results)
      if (result.quantity == quantity && result.where.empty() && std::isfinite(result.value))
        values.push_back(result.value);
  std::ranges::sort(values);
  return values;
}

std::vector<KnownInterval> known_intervals(const std::vector<double>& gaps, const std::vector<double>& beyond) {
  const auto records = static_cast<double>(gaps.size() + beyond.size());
  Check{"GapDemand", ""}.that(records >= 2.0 && !gaps.empty(), "records with a smallest gap", records, "1", ">= 2",
                              gaps.empty() && records > 0.0
                                  ? "All records need more than the largest gap: give a larger GapSearch::largest."
                                  : "A distribution needs several records with the result smallest_gap.");
  std::vector<KnownInterval> intervals;
  for (const double gap : gaps) intervals.push_back({gap, gap, 1.0});
  for (const double gap : beyond) intervals.push_back({.above = gap});
  return intervals;
}

std::string in_cm(double gap) { return to_significant(100.0 * gap, 4); }

}  // namespace

SmallestGap smallest_gap(const std::function<Length(Length gap)>& clearance_left, const GapSearch& search) {
  const Check check{"GapSearch", ""};
  check.positive("first", search.first);
  check.positive("accuracy", search.accuracy);
  check.that(search.largest.si() >= search.first.si(), "largest", search.largest.si(), "m", ">= first");
  const auto left = [&](double gap) { return clearance_left(Length{gap}).si(); };

  double open = search.first.si(), at_open = left(open), closed = 0.0;
  while (!(at_open > 0.0)) {
    if (open >= search.largest.si()) return {.gap = search.largest, .beyond = true};
    closed = open;
    open = std::min(2.0 * open, search.largest.si());
    at_open = left(open);
  }
  // Where the motion does not depend on the gap, the root is open - at_open. The gap is tried with a margin within the
  // accuracy.
  const double accuracy = search.accuracy.si();
  const double guess = open - at_open + 0.5 * accuracy;
  if (guess > closed && guess < open) {
    const double at_guess = left(guess);
    if (at_guess > 0.0 && at_guess < accuracy) return {Length{guess}};
    (at_guess > 0.0 ? open : closed) = guess;
  }
  // A gap of zero is closed by any motion: no analysis is needed.
  const auto function = [&](double gap) { return gap > 0.0 ? left(gap) : -1.0; };
  const Bracket bracket = bracket_root(function, closed, open, 0.5 * accuracy);
  // At a zero that was hit exactly the two sides touch.
  return {Length{bracket.low == bracket.high ? bracket.high + 0.5 * accuracy : bracket.high}};
}

StudyRecord smallest_gap_of(const std::function<StudyModel(Length gap)>& make, const GapSearch& search,
                            const TransientOptions& options) {
  const auto clearance_left = [&](Length gap) {
    StudyModel study = make(gap);
    double smallest = std::numeric_limits<double>::infinity();
    for (const NamedNumber& each : peaks_of(study.model, study.motion, options))
      if (each.quantity == "clearance_left") smallest = std::min(smallest, each.value);
    Check{"smallest_gap_of", ""}.that(std::isfinite(smallest), "the model has no gap.", "Add a Moat or a Gap.");
    return Length{smallest};
  };
  const SmallestGap found = smallest_gap(clearance_left, search);
  if (found.beyond)
    return {{"smallest_gap", "", "m", std::numeric_limits<double>::infinity()},
            {"smallest_gap_above", "", "m", found.gap.si()}};
  return {{"smallest_gap", "", "m", found.gap.si()}};
}

GapDemand::GapDemand(const StudyResult& study, double confidence)
    : gaps_{finite_results(study, "smallest_gap")},
      beyond_{finite_results(study, "smallest_gap_above")},
      without_solution_{study.count(CaseState::failed) + study.count(CaseState::not_converged)},
      fit_{known_intervals(gaps_, beyond_), confidence, "smallest gaps"} {}

std::string GapDemand::description() const {
  std::string text = std::to_string(gaps_.size()) + " records with a smallest gap from " + in_cm(gaps_.front()) +
                     " to " + in_cm(gaps_.back()) + " cm, ";
  if (!beyond_.empty())
    text += std::to_string(beyond_.size()) + " that need more than " + in_cm(beyond_.front()) + " cm, ";
  return text + std::to_string(without_solution_) + " without solution.";
}

Length GapDemand::gap(double probability_of_pounding) const {
  return Length{fit_.quantile(1.0 - probability_of_pounding)};
}

Bounds GapDemand::gap_bounds(double probability_of_pounding) const {
  return fit_.quantile_bounds(1.0 - probability_of_pounding);
}

Length GapDemand::empirical_gap(double share_that_pounds) const {
  Check{"GapDemand", ""}.that(share_that_pounds >= 0.0 && share_that_pounds < 1.0, "share_that_pounds",
                              share_that_pounds, "1", ">= 0 and < 1");
  const auto may_pound =
      std::min(static_cast<std::size_t>(share_that_pounds * static_cast<double>(records()) + 1e-9), records() - 1);
  const std::size_t open = records() - 1 - may_pound;
  return Length{open < gaps_.size() ? gaps_[open] : std::numeric_limits<double>::infinity()};
}

double GapDemand::probability(Length gap) const { return 1.0 - fit_.probability(gap.si()); }

Bounds GapDemand::probability_bounds(Length gap) const {
  const Bounds open = fit_.probability_bounds(gap.si());
  return {1.0 - open.high, 1.0 - open.low};
}

}  // namespace moat
