// A lognormal distribution by maximum likelihood, with confidence bounds.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace moat {

/// The bounds of one value: it lies above `above` and is at most `up_to`.
///
///     {2.0, 3.0}   between two levels       {2.0, inf}   more than 2, not reached      {2.0, 2.0}   exactly 2
struct KnownInterval {
  double above = 0.0;                                      ///< >= 0
  double up_to = std::numeric_limits<double>::infinity();  ///< > 0, >= above
  double count = 1.0;                                      ///< > 0, how many values it stands for
};

/// Lower and upper end; an end that the data leave open is 0 or infinite.
struct Bounds {
  double low = 0.0;  ///< >= 0
  /// >= low.
  double high = std::numeric_limits<double>::infinity();
};

/// F(x) = Phi(ln(x / median) / dispersion), the probability that a value is at most x.
class LognormalFit {
 public:
  /// Maximises the likelihood, the product of F(up_to) - F(above) over all intervals and of the density for exact
  /// values. In 1 / dispersion and ln(median) / dispersion its logarithm is concave (Pratt 1981), so that Newton's
  /// method finds the one maximum. Bounds come from the profile likelihood (Wilks 1938), which holds in small samples
  /// better than the curvature does.
  ///
  /// confidence: > 0, < 1, of all bounds. what: how messages call the values.
  ///
  /// Throws InputError for an interval that cannot be, and where there is no finite maximum. There is none where one
  /// value of x splits all intervals (the dispersion would be zero: more or closer levels are needed), or where no
  /// value has an upper end. Nor is there one where values above high levels and below low ones leave no increasing
  /// curve.
  explicit LognormalFit(std::vector<KnownInterval> intervals, double confidence = 0.95,
                        const std::string& what = "values");

  /// F(median) = 1/2, > 0.
  [[nodiscard]] double median() const { return median_; }
  /// Standard deviation of ln(x), > 0.
  [[nodiscard]] double dispersion() const { return dispersion_; }
  /// Probability of all bounds, > 0, < 1, as given.
  [[nodiscard]] double confidence() const { return confidence_; }
  /// With the confidence given.
  [[nodiscard]] Bounds median_bounds() const;
  /// With the confidence given.
  [[nodiscard]] Bounds dispersion_bounds() const;
  /// x > 0.
  [[nodiscard]] double probability(double x) const;
  /// Confidence bounds of F(x), x > 0.
  [[nodiscard]] Bounds probability_bounds(double x) const;
  /// The x that a share of all values, > 0 and < 1, does not exceed.
  [[nodiscard]] double quantile(double share) const;
  /// Confidence bounds of quantile(share), 0 < share < 1.
  [[nodiscard]] Bounds quantile_bounds(double share) const;
  /// The sum of their counts.
  [[nodiscard]] double count() const;

 private:
  // z = slope * y - shift, with y = (ln x - centre) / scale.
  struct Line {
    double slope, shift;
  };
  [[nodiscard]] double y_of(double x) const;
  [[nodiscard]] double log_likelihood(Line line) const;
  [[nodiscard]] Line best_line() const;
  // The largest log-likelihood of lines with z(y) = z, and of lines with this slope.
  [[nodiscard]] double profile_through(double y, double z) const;
  [[nodiscard]] double profile_of_slope(double slope) const;
  // Twice the loss of log-likelihood less its quantile: negative inside the bounds.
  [[nodiscard]] double excess(double log_likelihood) const;

  std::vector<KnownInterval> intervals_;
  double confidence_;
  std::string what_;
  double centre_ = 0.0, scale_ = 1.0;
  Line best_{1.0, 0.0};
  double largest_ = 0.0;  // log-likelihood
  double median_ = 0.0, dispersion_ = 0.0;
};

/// Clopper & Pearson's (1934) bounds of a probability of which `events` of `trials` are known: never narrower than
/// their confidence says. trials >= 1, 0 <= events <= trials.
Bounds binomial_bounds(int events, int trials, double confidence = 0.95);

}  // namespace moat
