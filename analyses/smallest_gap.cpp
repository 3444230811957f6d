#include "analyses/smallest_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/root.hpp"

namespace moat {
namespace {

std::vector<double> gaps_of(const StudyResult& study) {
  std::vector<double> gaps;
  for (const CaseOutcome& outcome : study.outcomes())
    if (outcome.state == CaseState::done) gaps.push_back(value_of(outcome.results, "smallest_gap", ""));
  Check{"GapDemand", ""}.that(gaps.size() >= 2, "records with a solution", static_cast<double>(gaps.size()), "1",
                              ">= 2", "A distribution needs several records.");
  std::ranges::sort(gaps);
  return gaps;
}

std::vector<KnownInterval> exact(const std::vector<double>& values) {
  std::vector<KnownInterval> intervals;
  for (const double value : values) intervals.push_back({value, value, 1.0});
  return intervals;
}

}  // namespace

Length smallest_gap(const std::function<Length(Length gap)>& clearance_left, const GapSearch& search) {
  const Check check{"GapSearch", ""};
  check.positive("first", search.first);
  check.positive("accuracy", search.accuracy);
  check.that(search.largest.si() >= search.first.si(), "largest", search.largest.si(), "m", ">= first");
  const auto left = [&](double gap) { return clearance_left(Length{gap}).si(); };

  double open = search.first.si(), at_open = left(open), closed = 0.0;
  while (!(at_open > 0.0)) {
    check.that(open < search.largest.si(), "even the largest gap, " + to_text(search.largest.si()) + " m, is closed.",
               "Give a larger one, or check the model.");
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
    if (at_guess > 0.0 && at_guess < accuracy) return Length{guess};
    (at_guess > 0.0 ? open : closed) = guess;
  }
  // A gap of zero is closed by any motion, and no clearance may be zero.
  const auto function = [&](double gap) { return gap > 0.0 ? left(gap) : -1.0; };
  const Bracket bracket = bracket_root(function, closed, open, 0.5 * accuracy);
  // At a zero that was hit exactly the two sides touch.
  return Length{bracket.low == bracket.high ? bracket.high + 0.5 * accuracy : bracket.high};
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
  return {{"smallest_gap", "", "m", smallest_gap(clearance_left, search).si()}};
}

GapDemand::GapDemand(const StudyResult& study, double confidence)
    : gaps_{gaps_of(study)},
      without_solution_{study.count(CaseState::failed) + study.count(CaseState::not_converged)},
      fit_{exact(gaps_), confidence, "smallest gaps"} {}

Length GapDemand::gap(double probability_of_pounding) const {
  return Length{fit_.quantile(1.0 - probability_of_pounding)};
}

Bounds GapDemand::gap_bounds(double probability_of_pounding) const {
  return fit_.quantile_bounds(1.0 - probability_of_pounding);
}

Length GapDemand::empirical_gap(double share_that_pounds) const {
  Check{"GapDemand", ""}.that(share_that_pounds >= 0.0 && share_that_pounds < 1.0, "share_that_pounds",
                              share_that_pounds, "1", ">= 0 and < 1");
  const auto may_pound = static_cast<std::size_t>(share_that_pounds * static_cast<double>(gaps_.size()) + 1e-9);
  return Length{gaps_[gaps_.size() - 1 - std::min(may_pound, gaps_.size() - 1)]};
}

double GapDemand::probability(Length gap) const { return 1.0 - fit_.probability(gap.si()); }

Bounds GapDemand::probability_bounds(Length gap) const {
  const Bounds open = fit_.probability_bounds(gap.si());
  return {1.0 - open.high, 1.0 - open.low};
}

}  // namespace moat
