// Statistics of a study over its records.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "study/result.hpp"

namespace moat {

/// Statistics of n magnitudes x >= 0, of which some may be infinite: collapsed.
///
/// The mean is their sum over n. Median and 84 % stand at the place p (n - 1) between the values in order, p = 0.5 and
/// 0.84. The lognormal ones are exp(mean ln x), and that times exp(beta), with beta the standard deviation of ln x by
/// n - 1; NaN unless all x are positive and finite, and n >= 2. All are NaN without values.
struct Statistics {
  /// No value.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  double mean = unknown, median = unknown, fractile_84 = unknown, largest = unknown;  ///< Infinite by collapse.
  std::size_t at_largest = 0;                                                         ///< Index of the largest.
  double lognormal_median = unknown, lognormal_84 = unknown, dispersion = unknown;    ///< The last is beta.
};
/// Returns the statistics of these magnitudes.
Statistics statistics_of(std::span<const double> magnitudes);

/// Fewest records whose mean is the design value; of fewer it is the largest. ASCE/SEI 7-16 and EN 1998-1
/// (recalled, not read: compare them with the edition that governs your project).
inline constexpr std::size_t fewest_for_mean = 7;

/// One result over the records of a study, for one combination of the other axes.
struct RecordStatistics {
  std::string quantity, where, unit;  ///< As those of a Peak.
  /// The other axes: "bounds = upper, direction = 90 deg"; empty where there are none. Of an envelope the combination
  /// with the largest design value.
  std::string group;
  bool envelope = false;  ///< Whether this is the largest of each statistic over all combinations.
  /// Clearances left have the mean, the fractiles from below (16 % in place of 84 %) and the smallest. NaN where no
  /// case is solved.
  Statistics statistics{};
  /// The mean of at least seven solved records, else the largest; of clearances left the smallest. Of an envelope the
  /// largest of the design values, each by the rule of its own combination.
  double design = Statistics::unknown;
  std::string record{};    ///< With the largest value.
  std::size_t solved = 0;  ///< Cases with this result; of an envelope the fewest.
  std::size_t collapsed =
      0;  ///< Solved cases that collapsed. They count as infinite, but not in quantities of pounding.
  std::size_t unsolved = 0;  ///< Cases that failed, did not converge, or are open. They do not count.
};

/// The cases of every combination of the other axes, with its name: "bounds = upper". In the order of the cases.
using StudyGroups = std::vector<std::pair<std::string, std::vector<std::size_t>>>;
/// Returns the groups of cases that differ in this axis alone.
StudyGroups groups_over(const StudyResult& study, std::string_view axis);

/// Statistics of all responses of a study over an axis, in the order of its table. Listed is every combination of the
/// other axes that has the response, or none of whose cases is solved; then the envelope if the study has several
/// combinations. Throws InputError for an unknown axis.
std::vector<RecordStatistics> statistics_over(const StudyResult& study, std::string_view axis = "record");

/// The axis of records of a study (record_axis()): the first whose values have files or samples behind them. Empty if
/// there is none.
std::string axis_of_records(const StudyResult& study);

/// A row for each, in SI units, for files and reports.
Table table_of(const std::vector<RecordStatistics>& list);

/// For a report: of every quantity the place that decides, of an envelope if there is one, in engineering units; and
/// how many records touch. Empty for a study without an axis of at least two records. list: statistics_over() it.
std::string statistics_section(const StudyResult& study, const std::vector<RecordStatistics>& list);

}  // namespace moat
