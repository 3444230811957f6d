// How errors are distributed over random models, one setting at a time.
#pragma once

#include <string>
#include <vector>

#include "random_trial.hpp"

namespace moat {

/// The relative error above which a run should warn.
inline constexpr double large_error = 5e-3;

/// How good moat's own error bars are, over the peaks that count of the models of one setting.
struct ErrorBarCheck {
  std::size_t peaks = 0;  ///< with an error bar
  double coverage = 0.0;  ///< share of them whose true error is at most the bar and the change of the reference
  double width = 0.0;     ///< median of bar over true error, where that is more than the change of the reference
};

/// The errors of the models of one setting, by their worst peak.
struct ErrorDistribution {
  std::vector<double> errors;      ///< relative, of the worst peak that counts, ascending
  std::vector<double> all_errors;  ///< of the worst of all peaks, ascending
  std::vector<double> steps;       ///< ascending
  int refused = 0;                 ///< models that moat refused or did not finish
  int other_impacts = 0;           ///< models with another number of impacts than the reference
  int large = 0;                   ///< models above large_error
  int large_and_warned = 0;        ///< of these, those whose run warned
  ErrorBarCheck bars;
};

/// Returns the errors of all models with setting number `setting`.
ErrorDistribution error_distribution(const std::vector<const TrialModel*>& models, std::size_t setting);

/// The smallest value that is not below the share of the sorted values; NaN without any.
double quantile(const std::vector<double>& sorted, double share);

/// Two digits: "0.12 %" of 0.0012.
std::string percent(double value);

/// A column for each setting.
std::string table_of(const std::vector<TrialSetting>& settings, const std::vector<ErrorDistribution>& distributions);

}  // namespace moat
