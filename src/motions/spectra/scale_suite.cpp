#include "motions/spectra/scale_suite.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/check.hpp"

namespace moat {
namespace {

constexpr const char* all_recalled = "; range and fraction recalled, not read in the code";
constexpr const char* range_recalled =
    "; range recalled, not read in the code, fraction as in the program QuakeManager";

// From `below` times the shorter period to `above` times the longer one.
SuiteScaling preset(const char* name, const std::string& source, Time shorter, Time longer, double below,
                    double above) {
  Check{"SuiteScaling", name}.that(
      shorter <= longer,
      "the first period, " + to_text(shorter.si()) + " s, is longer than the second, " + to_text(longer.si()) + " s.",
      "T_M of upper bounds is the shorter.");
  return {.name = name, .source = source, .shortest = below * shorter, .longest = above * longer};
}

}  // namespace

SuiteScaling SuiteScaling::asce_7_16(Time period_upper_bound, Time period_lower_bound) {
  return preset("ASCE 7-16", std::string{"ASCE/SEI 7-16 17.3.3"} + all_recalled, period_upper_bound, period_lower_bound,
                0.75, 1.25);
}

SuiteScaling SuiteScaling::asce_7_22(Time period_upper_bound, Time period_lower_bound) {
  SuiteScaling scaling = preset("ASCE 7-22", std::string{"ASCE/SEI 7-22 17.3 with 16.2.3.2"} + range_recalled,
                                period_upper_bound, period_lower_bound, 0.75, 1.25);
  scaling.spectrum = PairSpectrum::rotd100;
  scaling.fraction = 0.9;
  return scaling;
}

SuiteScaling SuiteScaling::asce_7_10(Time design_period, Time maximum_period) {
  return preset("ASCE 7-10", std::string{"ASCE/SEI 7-10"} + all_recalled, design_period, maximum_period, 0.5, 1.25);
}

SuiteScaling SuiteScaling::asce_7_ch16(Time shortest_period, Time longest_period) {
  SuiteScaling scaling = preset("ASCE 7 chapter 16", std::string{"ASCE/SEI 7 chapter 16"} + range_recalled,
                                shortest_period, longest_period, 0.2, 2.0);
  scaling.spectrum = PairSpectrum::rotd100;
  scaling.fraction = 0.9;
  scaling.least_pairs = 11;
  return scaling;
}

SuiteScaling SuiteScaling::en_1998_1(Time period_upper_bound, Time period_lower_bound) {
  SuiteScaling scaling = preset("EN 1998-1", std::string{"EN 1998-1:2004 3.2.3.1.2"} + all_recalled, period_upper_bound,
                                period_lower_bound, 0.2, 2.0);
  scaling.spectrum = PairSpectrum::each_component;
  scaling.fraction = 0.9;
  scaling.mean_at_zero = true;
  return scaling;
}

SuiteFactors suite_factors(const Eigen::ArrayXXd& spectra, const Eigen::ArrayXd& target, const Eigen::ArrayXd& required,
                           const Eigen::ArrayXd& weights, OwnFactor own_factor) {
  SuiteFactors factors;
  if (own_factor == OwnFactor::linear)
    factors.own = (spectra.colwise() * (weights * target)).colwise().sum() /
                  (spectra.square().colwise() * weights).colwise().sum();
  else
    factors.own =
        (((-spectra.log()).colwise() + target.log()).colwise() * weights / weights.sum()).colwise().sum().exp();
  const Eigen::ArrayXd mean = (spectra.rowwise() * factors.own.transpose()).rowwise().mean();
  factors.common = (required / mean).maxCoeff(&factors.governing);
  return factors;
}

ScaledSuite scale_suite(const std::vector<NamedPair>& pairs, const TargetSpectrum& target,
                        const SuiteScaling& scaling) {
  const Check check{"scale_suite", scaling.name};
  check.that(!pairs.empty(), "the suite has no records.", "Give at least one pair.");
  check.positive("fraction", scaling.fraction, "1");
  check.positive("shortest", scaling.shortest, "Give the range of scaling.");
  check.that(scaling.shortest < scaling.longest,
             "the range of scaling, " + to_text(scaling.shortest.si()) + " to " + to_text(scaling.longest.si()) +
                 " s, ends before it begins.",
             "T_M of upper bounds is the shorter.");
  std::set<std::string> names;
  for (const NamedPair& pair : pairs) {
    check.fits_tables(pair.name);
    check.that(names.insert(pair.name).second, "two records have the name " + pair.name + ".", "Name them apart.");
  }

  ScaledSuite suite{scaling, target, {}, {}, 0.0, {}, periods_between(scaling.shortest, scaling.longest)};
  std::vector<Time> periods = suite.periods;
  if (scaling.mean_at_zero) periods.emplace_back(0.0);
  const auto rows = static_cast<Eigen::Index>(periods.size()),
             in_range = static_cast<Eigen::Index>(suite.periods.size());
  Eigen::ArrayXd prescribed(rows), required(rows), weights(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Time period = periods[static_cast<std::size_t>(k)];
    prescribed[k] = target.acceleration(period).si();
    required[k] = k < in_range ? scaling.fraction * prescribed[k] : prescribed[k];
    weights[k] = k >= in_range ? 0.0 : scaling.weight ? scaling.weight(period) : 1.0;
    check.not_negative("weight at " + to_text(period.si()) + " s", weights[k], "1");
  }
  check.that(weights.sum() > 0.0, "all weights are zero.", "Give a weight > 0 to a period of the range.");

  // The rows of the second component stand behind those of the first.
  const Eigen::Index parts = scaling.spectrum == PairSpectrum::each_component ? 2 : 1;
  const auto columns = static_cast<Eigen::Index>(pairs.size());
  Eigen::ArrayXXd spectra(parts * rows, columns), srss(rows, columns), rotd100(rows, columns);
  for (Eigen::Index i = 0; i < columns; ++i) {
    const NamedPair& pair = pairs[static_cast<std::size_t>(i)];
    const PairSpectra of_pair = pair_spectra(pair.motion, periods, target.damping_ratio);
    const auto column = [&](const std::vector<double>& values) {
      return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    };
    spectra.col(i) = column(of_pair.of(scaling.spectrum));
    srss.col(i) = column(of_pair.srss);
    rotd100.col(i) = column(of_pair.rotd100);
    constexpr double round_off = 1e-9;  // of a component without motion, in turned axes
    check.that((spectra.col(i) > round_off * srss.col(i).replicate(parts, 1)).all(),
               "pair " + pair.name + " has no motion in the range" + (parts > 1 ? " in one of its components." : "."),
               parts > 1 ? "Leave it out, or set `spectrum`." : "Leave it out.");
  }

  const SuiteFactors factors = suite_factors(spectra, prescribed.replicate(parts, 1), required.replicate(parts, 1),
                                             weights.replicate(parts, 1), scaling.own_factor);
  suite.common_factor = scaling.only_up ? std::max(1.0, factors.common) : factors.common;
  suite.governing_period = periods[static_cast<std::size_t>(factors.governing % rows)];
  const Eigen::ArrayXd final_factors = suite.common_factor * factors.own;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double factor = final_factors[static_cast<Eigen::Index>(i)];
    suite.own_factors.push_back(factors.own[static_cast<Eigen::Index>(i)]);
    suite.pairs.push_back({pairs[i].name, pairs[i].motion.scaled_by(factor)});
    if (factor < scaling.allowed.first || factor > scaling.allowed.second)
      suite.warnings.push_back("The factor " + to_text(factor) + " of " + pairs[i].name + " is outside " +
                               to_text(scaling.allowed.first) + " to " + to_text(scaling.allowed.second) + ".");
  }
  if (pairs.size() < scaling.least_pairs)
    suite.warnings.push_back("Only " + std::to_string(pairs.size()) +
                             " records: " + (scaling.name.empty() ? "the rule" : scaling.name) + " asks for " +
                             std::to_string(scaling.least_pairs) +
                             ". The design value of a response is the mean of at least 7, else the largest.");
  const auto ratios = [&](const Eigen::ArrayXXd& values) -> Eigen::ArrayXXd {
    const Eigen::ArrayXd means = (values.rowwise() * final_factors.transpose()).rowwise().mean();
    const auto by_part = means.reshaped(rows, values.rows() / rows);
    return (by_part.colwise() / prescribed).topRows(in_range);
  };
  suite.least_ratio = ratios(spectra).minCoeff();
  suite.largest_ratio = ratios(spectra).maxCoeff();
  suite.least_srss_ratio = ratios(srss).minCoeff();
  suite.least_rotd100_ratio = ratios(rotd100).minCoeff();
  return suite;
}

std::vector<double> ScaledSuite::factors() const {
  std::vector<double> all = own_factors;
  for (double& factor : all) factor *= common_factor;
  return all;
}

std::vector<std::string> ScaledSuite::description() const {
  return {"Scaling by " + scaling.name + ": " + scaling.source, "Target: " + target.name + ": " + target.source,
          "Mean " + name_of(scaling.spectrum) + " of " + std::to_string(pairs.size()) +
              " records >= " + to_text(scaling.fraction) + " target from " + to_text(scaling.shortest.si()) + " to " +
              to_text(scaling.longest.si()) + " s, damping " + to_text(100.0 * target.damping_ratio) + " %",
          "Common factor " + to_text(common_factor) + ", governed at " + to_text(governing_period.si()) +
              " s; mean/target from " + to_text(least_ratio) + " to " + to_text(largest_ratio),
          "Least mean/target of SRSS " + to_text(least_srss_ratio) + ", of RotD100 " + to_text(least_rotd100_ratio)};
}

ScaledSuite scale_suite(const std::vector<Record>& records, const TargetSpectrum& target, const SuiteScaling& scaling) {
  std::vector<NamedPair> pairs;
  for (const Record& record : records) pairs.push_back({record.name, record.plan()});
  return scale_suite(pairs, target, scaling);
}

}  // namespace moat
