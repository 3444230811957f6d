// The smallest gap that nothing closes, for one record and for a suite.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/lognormal_fit.hpp"
#include "analyses/study.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"

namespace moat {

/// Where smallest_gap() looks.
struct GapSearch {
  Length first = 50 * units::cm;       ///< > 0, tried first
  Length largest = 10 * units::m;      ///< >= first; doubled gaps up to this are tried
  Length accuracy = 0.01 * units::mm;  ///< > 0
};

/// The gap at which the closest approach is zero: the root of clearance_left(gap), the smallest opening of all gaps
/// over time where they have this clearance at rest, negative where they are indented. Without contact the motion does
/// not depend on the gap, so that one analysis with a wide gap gives the root and a second confirms it; otherwise the
/// root is bracketed and found by the method of Alefeld, Potra and Shi.
///
/// The answer is a gap without contact, at most `accuracy` above one with contact. Throws InputError where even
/// `largest` is closed, and for a parameter outside its range.
Length smallest_gap(const std::function<Length(Length gap)>& clearance_left, const GapSearch& search = {});

/// The same for a model as a case of a study: the smallest `clearance_left` of all its gaps. The result is
/// `smallest_gap` [m].
///
///     const StudyResult study = script.study({record_axis("record", records)}, [&](const StudyCase& each) {
///       return smallest_gap_of([&](Length gap) { ... return StudyModel{model, records[each.position("record")]}; });
///     });
///     const GapDemand demand{study};
///     demand.gap(0.1);    // pounding is less than 10 % probable
StudyRecord smallest_gap_of(const std::function<StudyModel(Length gap)>& make, const GapSearch& search = {},
                            const TransientOptions& options = {});

/// The smallest gaps of a suite of records, as a distribution: the probability of pounding in a gap is that of a record
/// that needs more.
class GapDemand {
 public:
  /// One record per case of a study of smallest_gap_of(). Cases without a solution are counted apart. Throws InputError
  /// for a study without such results or with fewer than two.
  explicit GapDemand(const StudyResult& study, double confidence = 0.95);

  /// Ascending.
  [[nodiscard]] const std::vector<double>& gaps() const { return gaps_; }
  [[nodiscard]] std::size_t without_solution() const { return without_solution_; }
  /// Of the smallest gaps, lognormal.
  [[nodiscard]] const LognormalFit& fit() const { return fit_; }
  /// The gap at which pounding has this probability, > 0 and < 1, by the fit.
  [[nodiscard]] Length gap(double probability_of_pounding) const;
  /// Its confidence bounds, m.
  [[nodiscard]] Bounds gap_bounds(double probability_of_pounding) const;
  /// The smallest gap that is too narrow for at most this share of the records, without a distribution.
  [[nodiscard]] Length empirical_gap(double share_that_pounds) const;
  /// Of pounding in this gap, > 0, by the fit.
  [[nodiscard]] double probability(Length gap) const;
  [[nodiscard]] Bounds probability_bounds(Length gap) const;

 private:
  std::vector<double> gaps_;  // m
  std::size_t without_solution_ = 0;
  LognormalFit fit_;
};

}  // namespace moat
