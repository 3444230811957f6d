#include "analyses/questions/lognormal_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/root.hpp"

namespace moat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The largest likelihood along a line is looked for so far around the middle, in widths of the data.
constexpr double range = 12.0;

double density(double z) { return std::isinf(z) ? 0.0 : std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

double normal(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normal_quantile(double share) { return boost::math::quantile(boost::math::normal_distribution<>{}, share); }

// Phi(high) - Phi(low) in the tail where both are small.
double normal_between(double low, double high) {
  return low > 0.0 ? normal(-low) - normal(-high) : normal(high) - normal(low);
}

/// The largest value of a function of one maximum.
double largest_value(const std::function<double(double)>& function, double low, double high) {
  // No likelihood is as small, and differences of this number do not overflow.
  constexpr double nothing = std::numeric_limits<float>::max();
  const auto upside_down = [&](double x) {
    const double value = function(x);
    return std::isfinite(value) ? -value : nothing;
  };
  return -boost::math::tools::brent_find_minima(upside_down, low, high, std::numeric_limits<double>::digits).second;
}

/// The place in one direction from `inside` where an excess grows beyond zero; infinite where it does not.
double end_of(const std::function<double(double)>& excess, double inside, double step) {
  double near = inside;
  for (; std::abs(step) * std::numeric_limits<double>::epsilon() < 1.0; step *= 2.0) {
    const double far = inside + step;
    if (excess(far) > 0.0) return root_between(excess, std::min(near, far), std::max(near, far));
    near = far;
  }
  return step > 0.0 ? infinity : -infinity;
}

}  // namespace

LognormalFit::LognormalFit(std::vector<KnownInterval> intervals, double confidence, const std::string& what)
    : intervals_{std::move(intervals)}, confidence_{confidence}, what_{what} {
  const Check check{"LognormalFit", what_};
  check.that(confidence > 0.0 && confidence < 1.0, "confidence", confidence, "1", "> 0 and < 1");
  check.that(!intervals_.empty(), "there are no values.", "Give at least two.");
  double largest_low = 0.0, smallest_high = infinity, smallest = infinity, largest = 0.0;
  bool all_exact = true;
  for (const KnownInterval& each : intervals_) {
    check.not_negative("above", each.above, "the values' unit");
    check.that(each.up_to > 0.0 && each.up_to >= each.above, "up_to", each.up_to, "the values' unit",
               "> 0 and >= above");
    check.positive("count", each.count, "1");
    largest_low = std::max(largest_low, each.above);
    smallest_high = std::min(smallest_high, each.up_to);
    all_exact = all_exact && each.above == each.up_to;
    for (const double end : {each.above, each.up_to})
      if (end > 0.0 && std::isfinite(end)) {
        smallest = std::min(smallest, end);
        largest = std::max(largest, end);
      }
  }
  check.that(std::isfinite(smallest_high), "no value has an upper end: the event never happened.",
             "Extend the levels until it happens.");
  check.that(largest_low > smallest_high, "one value splits all data, so that the dispersion would be zero.",
             "Give levels between those without and with the event, or more records.");
  centre_ = 0.5 * (std::log(smallest) + std::log(largest));
  scale_ = std::max(0.5 * (std::log(largest) - std::log(smallest)), 1e-12);
  best_ = best_line();
  largest_ = log_likelihood(best_);
  dispersion_ = scale_ / best_.slope;
  median_ = std::exp(centre_ + scale_ * best_.shift / best_.slope);
}

double LognormalFit::y_of(double x) const {
  return x <= 0.0 ? -infinity : std::isinf(x) ? infinity : (std::log(x) - centre_) / scale_;
}

double LognormalFit::count() const {
  double sum = 0.0;
  for (const KnownInterval& each : intervals_) sum += each.count;
  return sum;
}

double LognormalFit::log_likelihood(Line line) const {
  if (!(line.slope > 0.0)) return -infinity;
  const auto z = [&](double y) { return std::isinf(y) ? y : line.slope * y - line.shift; };
  double sum = 0.0;
  for (const KnownInterval& each : intervals_) {
    const double low = z(y_of(each.above)), high = z(y_of(each.up_to));
    // A density up to a constant factor.
    sum += each.count *
           (each.above == each.up_to ? std::log(line.slope) - 0.5 * low * low : std::log(normal_between(low, high)));
  }
  return sum;
}

LognormalFit::Line LognormalFit::best_line() const {
  Line line{1.0, 0.0};
  double value = log_likelihood(line);
  for (bool grows = true; grows;) {
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    for (const KnownInterval& each : intervals_) {
      const auto z = [&](double y) { return std::isinf(y) ? y : line.slope * y - line.shift; };
      const double y_low = y_of(each.above), y_high = y_of(each.up_to);
      if (each.above == each.up_to) {
        const Eigen::Vector2d dz{y_low, -1.0};
        gradient += each.count * (Eigen::Vector2d{1.0 / line.slope, 0.0} - z(y_low) * dz);
        hessian -= each.count * dz * dz.transpose();
        hessian(0, 0) -= each.count / (line.slope * line.slope);
        continue;
      }
      Eigen::Vector2d first = Eigen::Vector2d::Zero();
      Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
      for (const auto& [y, sign] : {std::pair{y_high, 1.0}, std::pair{y_low, -1.0}}) {
        if (!std::isfinite(y)) continue;
        const Eigen::Vector2d dz{y, -1.0};
        first += sign * density(z(y)) * dz;
        second -= sign * z(y) * density(z(y)) * dz * dz.transpose();
      }
      const double probability = normal_between(z(y_low), z(y_high));
      gradient += each.count * first / probability;
      hessian += each.count * (second / probability - first * first.transpose() / (probability * probability));
    }
    // The step is -H^-1 g.
    const Eigen::Vector2d step = Eigen::Vector2d{hessian(0, 1) * gradient[1] - hessian(1, 1) * gradient[0],
                                                 hessian(1, 0) * gradient[0] - hessian(0, 0) * gradient[1]} /
                                 (hessian(0, 0) * hessian(1, 1) - hessian(0, 1) * hessian(1, 0));
    // The function is concave: a part of Newton's step increases it, until the rest is round-off.
    grows = false;
    for (double share = 1.0; !grows && share > std::numeric_limits<double>::epsilon(); share *= 0.5) {
      const Line next{line.slope + share * step[0], line.shift + share * step[1]};
      const double next_value = log_likelihood(next);
      if (!(grows = next_value > value)) continue;
      line = next;
      value = next_value;
    }
  }
  constexpr double smallest_slope = 1e-3;
  Check{"LognormalFit", what_}.that(line.slope > smallest_slope && std::isfinite(value),
                                    "the probability does not grow with the level.",
                                    "Check the data: the event happens at low levels and not at high ones.");
  return line;
}

double LognormalFit::profile_through(double y, double z) const {
  const double middle = std::log(best_.slope);
  return largest_value(
      [&](double log_slope) {
        const double slope = std::exp(log_slope);
        return log_likelihood({slope, slope * y - z});
      },
      middle - range, middle + range);
}

double LognormalFit::profile_of_slope(double slope) const {
  return largest_value([&](double middle) { return log_likelihood({slope, slope * middle}); }, -range, range);
}

double LognormalFit::excess(double log_likelihood) const {
  const double z = normal_quantile(0.5 * (1.0 + confidence_));
  return 2.0 * (largest_ - log_likelihood) - z * z;
}

Bounds LognormalFit::quantile_bounds(double share) const {
  Check{"LognormalFit", what_}.that(share > 0.0 && share < 1.0, "share", share, "1", "> 0 and < 1");
  const double z = normal_quantile(share), at = (z + best_.shift) / best_.slope;
  const auto outside = [&](double y) { return excess(profile_through(y, z)); };
  const double step = 1.0 / best_.slope;
  return {std::exp(centre_ + scale_ * end_of(outside, at, -step)),
          std::exp(centre_ + scale_ * end_of(outside, at, step))};
}

Bounds LognormalFit::median_bounds() const { return quantile_bounds(0.5); }

Bounds LognormalFit::dispersion_bounds() const {
  const auto outside = [&](double log_dispersion) {
    return excess(profile_of_slope(scale_ * std::exp(-log_dispersion)));
  };
  const double at = std::log(dispersion_);
  return {std::exp(end_of(outside, at, -1.0)), std::exp(end_of(outside, at, 1.0))};
}

double LognormalFit::probability(double x) const { return normal(best_.slope * y_of(x) - best_.shift); }

Bounds LognormalFit::probability_bounds(double x) const {
  Check{"LognormalFit", what_}.positive("x", x, "the values' unit");
  const double y = y_of(x), at = best_.slope * y - best_.shift;
  const auto outside = [&](double z) { return excess(profile_through(y, z)); };
  return {normal(end_of(outside, at, -1.0)), normal(end_of(outside, at, 1.0))};
}

double LognormalFit::quantile(double share) const {
  Check{"LognormalFit", what_}.that(share > 0.0 && share < 1.0, "share", share, "1", "> 0 and < 1");
  return median_ * std::exp(dispersion_ * normal_quantile(share));
}

Bounds binomial_bounds(int events, int trials, double confidence) {
  const Check check{"binomial_bounds", ""};
  check.that(trials >= 1, "trials", trials, "1", ">= 1");
  check.that(events >= 0 && events <= trials, "events", events, "1", ">= 0 and <= trials");
  check.that(confidence > 0.0 && confidence < 1.0, "confidence", confidence, "1", "> 0 and < 1");
  const double tail = 0.5 * (1.0 - confidence);
  Bounds bounds{0.0, 1.0};
  if (events > 0)
    bounds.low = boost::math::quantile(boost::math::beta_distribution<>{1.0 * events, trials - events + 1.0}, tail);
  if (events < trials)
    bounds.high = boost::math::quantile(
        boost::math::complement(boost::math::beta_distribution<>{events + 1.0, 1.0 * (trials - events)}, tail));
  return bounds;
}

}  // namespace moat
