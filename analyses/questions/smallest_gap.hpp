// The smallest gap that nothing closes, for one record and for a suite.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/questions/lognormal_fit.hpp"
#include "analyses/questions/study.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"

namespace moat {

/// Where smallest_gap() looks.
struct GapSearch {
  Length first = 50 * units::cm;       ///< > 0, tried first
  Length largest = 10 * units::m;      ///< >= first; doubled gaps up to this are tried
  Length accuracy = 0.01 * units::mm;  ///< > 0
};

/// The answer of smallest_gap().
struct SmallestGap {
  /// Without contact, at most GapSearch::accuracy above one with contact; if `beyond`, GapSearch::largest.
  Length gap{};
  /// Even the largest gap is closed: the smallest gap is larger than `gap`, and not known.
  bool beyond = false;
};

/// The gap at which the closest approach is zero: the root of clearance_left(gap), the smallest opening of all gaps
/// over time where they have this clearance at rest, negative where they are indented. Without contact the motion does
/// not depend on the gap, so that one analysis with a wide gap gives the root and a second confirms it; otherwise the
/// root is bracketed and found by the method of Alefeld, Potra and Shi.
///
/// Throws InputError for a parameter outside its range.
SmallestGap smallest_gap(const std::function<Length(Length gap)>& clearance_left, const GapSearch& search = {});

/// Finds the smallest gap of a model, as a case of a study, from the smallest `clearance_left` of all its gaps. The
/// result is `smallest_gap` [m]. Where even the largest gap is closed, it is infinite, and a second result,
/// `smallest_gap_above` [m], is that largest gap: the case is done, and known to need more.
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
  /// One record per case of a study of smallest_gap_of(). Records that need more than the largest gap are values of
  /// which a lower end is known (censored data): they count in the fit and in every share. Cases without a solution are
  /// counted apart. Throws InputError for a study without such results, with fewer than two records, or none with a
  /// gap.
  explicit GapDemand(const StudyResult& study, double confidence = 0.95);

  /// Those that were found, ascending, m.
  [[nodiscard]] const std::vector<double>& gaps() const { return gaps_; }
  /// The largest gaps of the records that need more, ascending, m.
  [[nodiscard]] const std::vector<double>& beyond() const { return beyond_; }
  /// gaps() and beyond() together.
  [[nodiscard]] std::size_t records() const { return gaps_.size() + beyond_.size(); }
  [[nodiscard]] std::size_t without_solution() const { return without_solution_; }  ///< Cases that did not converge.
  /// "18 records with a smallest gap from 12.1 to 30.2 cm, 2 that need more than 50 cm, 0 without solution."
  [[nodiscard]] std::string description() const;
  /// Returns the lognormal fit to the smallest gaps.
  [[nodiscard]] const LognormalFit& fit() const { return fit_; }
  /// The gap at which pounding has this probability, > 0 and < 1, by the fit.
  [[nodiscard]] Length gap(double probability_of_pounding) const;
  /// Its confidence bounds, m.
  [[nodiscard]] Bounds gap_bounds(double probability_of_pounding) const;
  /// The smallest gap that is too narrow for at most this share of the records, without a distribution; infinite where
  /// more records than that need more than the largest gap.
  [[nodiscard]] Length empirical_gap(double share_that_pounds) const;
  /// Returns the probability of pounding in this gap, > 0, by the fit.
  [[nodiscard]] double probability(Length gap) const;
  [[nodiscard]] Bounds probability_bounds(Length gap) const;  ///< Its confidence bounds.

 private:
  std::vector<double> gaps_, beyond_;  // m
  std::size_t without_solution_ = 0;
  LognormalFit fit_;
};

}  // namespace moat
