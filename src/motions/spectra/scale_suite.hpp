// Pairs of records scaled together to a target spectrum.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/quantity.hpp"
#include "motions/plan_motion.hpp"
#include "motions/readers/record.hpp"
#include "motions/spectra/pair_spectra.hpp"
#include "motions/spectra/target_spectrum.hpp"

namespace moat {

/// How the own factor f of a pair with the spectrum S fits the target t, with weights w over the periods of the range.
/// Either ln f = sum w (ln t - ln S)/sum w, or f = sum w t S/sum w S^2.
enum class OwnFactor { logarithmic, linear };

/// How a suite is scaled. Every field can be changed after a preset:
///
///     SuiteScaling scaling = SuiteScaling::asce_7_16(2.16 * s, 2.82 * s);
///     scaling.fraction = 0.9;
struct SuiteScaling {
  std::string name{}, source{};                ///< The code, and the origin of range and fraction.
  PairSpectrum spectrum = PairSpectrum::srss;  ///< Compared with the target; of `each_component` both are.
  Time shortest{}, longest{};                  ///< The range: 0 < shortest < longest.
  double fraction = 1.0;                       ///< The mean reaches this share of the target in the range; > 0.
  /// How the factor of a pair is found.
  OwnFactor own_factor = OwnFactor::logarithmic;
  std::function<double(Time)> weight{};          ///< >= 0 at every period of the range; 1 if not given.
  bool only_up = false;                          ///< The common factor is at least 1.
  bool mean_at_zero = false;                     ///< At T = 0 the mean reaches the whole target.
  std::pair<double, double> allowed{0.25, 4.0};  ///< Final factors outside are warned of.
  std::size_t least_pairs = 7;                   ///< Fewer are warned of.

  /// ASCE/SEI 7-16, chapter 17: SRSS not below MCE_R from 0.75 T_M (upper bounds of the properties) to 1.25 T_M (lower
  /// bounds); range and fraction recalled, not read in the code. These throw InputError for the longer period first.
  static SuiteScaling asce_7_16(Time period_upper_bound, Time period_lower_bound);
  /// ASCE/SEI 7-22, chapters 17 and 16: RotD100 not below 0.9 MCE_R over the same range, which is recalled, not read in
  /// the code; the fraction as in the program QuakeManager.
  static SuiteScaling asce_7_22(Time period_upper_bound, Time period_lower_bound);
  /// ASCE/SEI 7-10: SRSS not below the target from 0.5 T_D to 1.25 T_M; recalled, not read in the code.
  static SuiteScaling asce_7_10(Time design_period, Time maximum_period);
  /// ASCE/SEI 7 chapter 16: RotD100 of 11 pairs not below 0.9 MCE_R from 0.2 of the shortest to twice the longest
  /// period; range recalled, not read in the code, fraction as in QuakeManager.
  static SuiteScaling asce_7_ch16(Time shortest_period, Time longest_period);
  /// EN 1998-1: the mean of each component not below 0.9 S_e from 0.2 T_1 to 2 T_1, nor below a_g S at T = 0;
  /// recalled, not read in the code. T_1 of isolated buildings changes with the bounds: the range spans those of both,
  /// the shorter one first. EN 1998-2 has srss_over_1_3 instead.
  static SuiteScaling en_1998_1(Time period_upper_bound, Time period_lower_bound);
  /// Takes one T_1 for both bounds.
  static SuiteScaling en_1998_1(Time first_period) { return en_1998_1(first_period, first_period); }
};

/// A record of a suite.
struct NamedPair {
  std::string name;   ///< Different for every record.
  PlanMotion motion;  ///< Both horizontal components.
};

/// Factors of a suite.
struct SuiteFactors {
  Eigen::ArrayXd own;      ///< One per pair.
  double common;           ///< The final factors are common * own.
  Eigen::Index governing;  ///< The period at which the mean is just as required.
};

/// The rule of scale_suite() on numbers > 0: spectra (row: period, column: pair), target and weights (>= 0, with a
/// positive sum) of the own factors, and values that the mean of the scaled pairs must reach: common = max over periods
/// of required/mean(own spectra).
[[nodiscard]] SuiteFactors suite_factors(const Eigen::ArrayXXd& spectra, const Eigen::ArrayXd& target,
                                         const Eigen::ArrayXd& required, const Eigen::ArrayXd& weights,
                                         OwnFactor own_factor);

/// A suite with one factor per pair, for all of its components.
struct ScaledSuite {
  /// The rule.
  SuiteScaling scaling;
  /// The target.
  TargetSpectrum target;
  std::vector<NamedPair> pairs;     ///< Scaled.
  std::vector<double> own_factors;  ///< One for each pair.
  double common_factor;             ///< Multiplies all pairs.
  Time governing_period;            ///< SuiteFactors::governing; only_up may hold the mean above the requirement.
  std::vector<Time> periods;        ///< The grid of the range.
  /// Least and largest ratio of the mean to the target in the range, of both means for `each_component`; the least ones
  /// of the mean SRSS and the mean RotD100, which is 0.71 to 1.0 of SRSS.
  double least_ratio = 0.0, largest_ratio = 0.0, least_srss_ratio = 0.0, least_rotd100_ratio = 0.0;
  std::vector<std::string> warnings{};  ///< Sentences for the user.

  /// Final factors, common times own.
  [[nodiscard]] std::vector<double> factors() const;
  /// Lines for a report: rule, range, fraction, common factor, ratios.
  [[nodiscard]] std::vector<std::string> description() const;
};

/// Scales each pair by its own factor, and all by a common one that lifts (or, unless only_up, lowers) their mean to
/// fraction times target where it is least over it. Spectra have the damping of the target, and periods from
/// periods_between() over the range. Throws InputError for no pair, a name that is taken, a range outside that of the
/// target or with its ends exchanged, and a pair without motion.
[[nodiscard]] ScaledSuite scale_suite(const std::vector<NamedPair>& pairs, const TargetSpectrum& target,
                                      const SuiteScaling& scaling);

/// Records as read_records() gives them. Throws InputError for one of one horizontal component too.
[[nodiscard]] ScaledSuite scale_suite(const std::vector<Record>& records, const TargetSpectrum& target,
                                      const SuiteScaling& scaling);

}  // namespace moat
