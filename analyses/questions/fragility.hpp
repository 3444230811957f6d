// How probable an event is, against a level of the ground motion or against a gap.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/questions/lognormal_fit.hpp"
#include "base/quantity.hpp"
#include "study/result.hpp"

namespace moat {

/// Whether an event happened in a case that is done.
using StudyEvent = std::function<bool(const CaseOutcome&)>;

/// The event that a result exceeds a threshold, in the result's SI unit. The event throws InputError for a case without
/// this result.
StudyEvent exceeds(std::string quantity, std::string where, double threshold);
/// The event that a result exceeds a threshold with its dimension: exceeds("drift", "storey 1", 2 * cm). It throws
/// InputError too for a result that has another unit than `unit`, the SI unit of the threshold.
StudyEvent exceeds(std::string quantity, std::string where, double threshold, std::string unit);
/// As the function above, whose unit is that of the threshold.
template <class Q>
requires requires { Q::mass_exponent; }
StudyEvent exceeds(std::string quantity, std::string where, Q threshold) {
  return exceeds(std::move(quantity), std::move(where), threshold.si(), unit_symbol<Q>());
}
/// The event that anything hit anything: `impacts` > 0.
StudyEvent pounds();

/// How often an event happened at one value of an axis.
struct EventCount {
  double level = 0.0;  ///< value on the axis
  int trials = 0;      ///< cases that are done
  int events = 0;      ///< of these
  /// Cases that failed or did not converge. They are no trials: neither events nor their absence.
  int without_solution = 0;
};

/// One for every value of the axis, ascending. Throws InputError for an unknown axis.
std::vector<EventCount> event_counts(const StudyResult& study, std::string_view axis, const StudyEvent& event);

/// How an event depends on an axis.
enum class Trend {
  grows,   ///< as drift with the intensity: it happens from some level on
  shrinks  ///< as pounding with the gap: it happens up to some level
};

/// The level at which the event begins (grows) or ends (shrinks), for every combination of the other axes, for example
/// every record: between the neighbouring levels without and with the event. Where it comes and goes, the lowest level
/// with the event counts (grows), or the highest (shrinks). Cases without a solution widen the interval;
/// a combination that has no other case is left out.
std::vector<KnownInterval> event_limits(const StudyResult& study, std::string_view axis, const StudyEvent& event,
                                        Trend trend);

/// A fragility: P(event | level) = Phi(ln(level / median) / dispersion), fitted to the limits of all records, whose
/// answers at different levels are not independent of each other. Records that differ from level to level are
/// combinations of their own; their limits are then open on one side, and the fit is that of Baker (2015). For an event
/// that shrinks, F is the probability that it does not happen. Throws as event_counts() and LognormalFit.
LognormalFit fit_fragility(const StudyResult& study, std::string_view axis, const StudyEvent& event,
                           Trend trend = Trend::grows, double confidence = 0.95);

/// The smallest gaps of a suite of records, as a distribution: the probability of pounding in a gap is that of a record
/// that needs more.
class GapDemand {
 public:
  /// One record per case of a study of smallest_gap_of(). Records that need more than the largest gap are values of
  /// which a lower end is known (censored data): they count in the fit and in every share. Cases without a solution are
  /// counted apart. Throws InputError for a study without such results, with fewer than two records, or none with a
  /// gap.
  explicit GapDemand(const StudyResult& study, double confidence = 0.95);

  /// Returns the gaps that were found, ascending, m.
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
  /// Returns the confidence bounds of gap(), m.
  [[nodiscard]] Bounds gap_bounds(double probability_of_pounding) const;
  /// The smallest gap that is too narrow for at most this share of the records, without a distribution; infinite where
  /// more records than that need more than the largest gap.
  [[nodiscard]] Length empirical_gap(double share_that_pounds) const;
  /// Returns the probability of pounding in this gap, > 0, by the fit.
  [[nodiscard]] double probability(Length gap) const;
  [[nodiscard]] Bounds probability_bounds(Length gap) const;  ///< Confidence bounds of probability().

 private:
  std::vector<double> gaps_, beyond_;  // m
  std::size_t without_solution_ = 0;
  LognormalFit fit_;
};

}  // namespace moat
