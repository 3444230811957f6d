#include "analyses/questions/smallest_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/root.hpp"

namespace moat {
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

}  // namespace moat
