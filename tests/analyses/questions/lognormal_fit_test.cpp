// Lognormal distributions by maximum likelihood.

#include "analyses/questions/lognormal_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using testing::message_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<KnownInterval> exact(const std::vector<double>& values) {
  std::vector<KnownInterval> list;
  for (const double value : values) list.push_back({value, value, 1.0});
  return list;
}

std::vector<double> draw(std::mt19937_64& random, int count, double median, double dispersion) {
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(median * std::exp(dispersion * normal(random)));
  return values;
}

TEST(LognormalFit, OfExactValuesIsTheirMeanAndDeviation) {
  const std::vector<double> values{0.8, 1.1, 1.7, 2.5, 0.4};
  double mean = 0.0, square = 0.0;
  for (const double value : values) mean += std::log(value) / 5.0;
  for (const double value : values) square += std::pow(std::log(value) - mean, 2) / 5.0;
  const LognormalFit fit{exact(values)};
  EXPECT_NEAR(fit.median(), std::exp(mean), 1e-9);
  EXPECT_NEAR(fit.dispersion(), std::sqrt(square), 1e-9);
  // Profile of a normal mean: n ln(1 + (m - mean)^2 / s^2) = chi^2.
  const double chi2 = 3.841458820694124, half = std::sqrt(square * std::expm1(chi2 / 5.0));
  EXPECT_NEAR(fit.median_bounds().low, std::exp(mean - half), 1e-6);
  EXPECT_NEAR(fit.median_bounds().high, std::exp(mean + half), 1e-6);
  // Of the deviation: n (2 ln(s / best) + best^2 / s^2 - 1) = chi^2.
  for (const double bound : {fit.dispersion_bounds().low, fit.dispersion_bounds().high}) {
    const double ratio = std::sqrt(square) / bound;
    EXPECT_NEAR(5.0 * (-2.0 * std::log(ratio) + ratio * ratio - 1.0), chi2, 1e-5);
  }
}

TEST(LognormalFit, OfTwoStripesSolvesThemExactly) {
  // 2 of 10 at level 1, 7 of 10 at level 2: two parameters fit two shares.
  const LognormalFit fit{{{0.0, 1.0, 2.0}, {1.0, infinity, 8.0}, {0.0, 2.0, 7.0}, {2.0, infinity, 3.0}}};
  EXPECT_NEAR(fit.probability(1.0), 0.2, 1e-8);
  EXPECT_NEAR(fit.probability(2.0), 0.7, 1e-8);
  EXPECT_EQ(fit.count(), 20.0);
  EXPECT_NEAR(fit.quantile(0.7), 2.0, 1e-7);
  EXPECT_NEAR(fit.probability(fit.median()), 0.5, 1e-12);
}

// The likelihood is largest: no neighbour has a larger one.
TEST(LognormalFit, NoOtherCurveIsMoreProbable) {
  std::mt19937_64 random{3};
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<KnownInterval> intervals;
    for (const double value : draw(random, 25, 0.7, 0.5)) {
      const double above = 0.2 * std::floor(value / 0.2);
      intervals.push_back(value > 1.2 ? KnownInterval{1.2, infinity} : KnownInterval{above, above + 0.2});
    }
    const LognormalFit fit{intervals};
    const auto likelihood = [&](double median, double dispersion) {
      const auto F = [&](double x) {
        if (x <= 0.0) return 0.0;
        return std::isinf(x) ? 1.0 : 0.5 * std::erfc(-std::log(x / median) / dispersion / std::sqrt(2.0));
      };
      double sum = 0.0;
      for (const KnownInterval& each : intervals) sum += std::log(F(each.up_to) - F(each.above));
      return sum;
    };
    const double best = likelihood(fit.median(), fit.dispersion());
    for (int i = 0; i < 16; ++i) {
      const double angle = i * std::acos(-1.0) / 8.0;
      EXPECT_LT(likelihood(fit.median() * std::exp(1e-3 * std::cos(angle)),
                           fit.dispersion() * std::exp(1e-3 * std::sin(angle))),
                best);
    }
    // At both bounds of the median the best dispersion loses half of chi^2.
    for (const double median : {fit.median_bounds().low, fit.median_bounds().high}) {
      double profile = -infinity;
      for (double d = 0.05; d < 3.0; d *= 1.001) profile = std::max(profile, likelihood(median, d));
      EXPECT_NEAR(2.0 * (best - profile), 3.841458820694124, 1e-3);
    }
  }
}

// Repetitions of 100 whose bounds hold the truth.
using Observe = std::function<std::vector<KnownInterval>(std::mt19937_64&)>;
struct Coverage {
  int median = 0, dispersion = 0, probability = 0;
};
Coverage coverage(std::uint64_t seed, const Observe& observe) {
  std::mt19937_64 random{seed};
  Coverage held;
  for (int i = 0; i < 100; ++i) {
    const LognormalFit fit{observe(random)};
    const auto holds = [](Bounds bounds, double truth) { return bounds.low <= truth && truth <= bounds.high ? 1 : 0; };
    held.median += holds(fit.median_bounds(), 0.5);
    held.dispersion += holds(fit.dispersion_bounds(), 0.4);
    held.probability += holds(fit.probability_bounds(0.3), 0.5 * std::erfc(-std::log(0.6) / 0.4 / std::sqrt(2.0)));
  }
  return held;
}

void expect_coverage(const Coverage& held, const std::string& what) {
  for (const int count : {held.median, held.dispersion, held.probability}) {
    EXPECT_GE(count, 90) << what;
    EXPECT_LE(count, 99) << what;
  }
}

TEST(LognormalFit, BoundsHoldTheTruthAsOftenAsTheySay) {
  expect_coverage(coverage(11, [](std::mt19937_64& random) { return exact(draw(random, 40, 0.5, 0.4)); }), "exact");
  // Records that are analysed at fixed levels up to 1.
  expect_coverage(
      coverage(12,
               [](std::mt19937_64& random) {
                 std::vector<KnownInterval> list;
                 for (const double x : draw(random, 40, 0.5, 0.4)) {
                   const double above = 0.1 * std::floor(10.0 * x);
                   list.push_back(x > 1.0 ? KnownInterval{1.0, infinity} : KnownInterval{above, above + 0.1});
                 }
                 return list;
               }),
      "intervals");
  // Other records at every level.
  expect_coverage(coverage(13,
                           [](std::mt19937_64& random) {
                             std::vector<KnownInterval> list;
                             for (double level = 0.2; level < 1.05; level += 0.1)
                               for (const double x : draw(random, 20, 0.5, 0.4))
                                 list.push_back(x > level ? KnownInterval{level, infinity} : KnownInterval{0.0, level});
                             return list;
                           }),
                  "stripes");
}

TEST(LognormalFit, DoesNotDependOnTheUnit) {
  const std::vector<double> values{0.8, 1.1, 1.7, 2.5, 0.4};
  std::vector<KnownInterval> small, large;
  for (const double value : values) {
    small.push_back({0.9e-6 * value, 1.1e-6 * value});
    large.push_back({0.9e6 * value, 1.1e6 * value});
  }
  const LognormalFit a{small}, b{large};
  EXPECT_NEAR(a.median() * 1e12 / b.median(), 1.0, 1e-7);
  EXPECT_NEAR(a.dispersion(), b.dispersion(), 1e-7);
  EXPECT_NEAR(a.quantile_bounds(0.9).high * 1e12 / b.quantile_bounds(0.9).high, 1.0, 1e-6);
}

TEST(LognormalFit, RefusesDataWithoutAMaximum) {
  const auto refused = [](std::vector<KnownInterval> data) {
    return message_of<InputError>([&] { (void)LognormalFit{std::move(data)}; });
  };
  EXPECT_NE(refused({}).find("there are no values"), std::string::npos);
  EXPECT_NE(refused({{1.0, infinity}, {2.0, infinity}}).find("the event never happened"), std::string::npos);
  EXPECT_NE(refused({{0.0, 1.0}, {1.0, 2.0}}).find("one value splits all data"), std::string::npos);
  EXPECT_NE(refused({{1.0, 1.0}, {1.0, 1.0}}).find("one value splits all data"), std::string::npos);
  EXPECT_NE(refused({{0.0, 1.0, 5.0}, {1.0, infinity, 5.0}, {0.0, 2.0, 5.0}, {2.0, infinity, 5.0}})
                .find("does not grow with the level"),
            std::string::npos);
  EXPECT_NE(refused({{0.0, 1.0, 9.0}, {1.0, infinity, 1.0}, {0.0, 2.0, 2.0}, {2.0, infinity, 8.0}})
                .find("does not grow with the level"),
            std::string::npos);
  EXPECT_NE(refused({{2.0, 1.0}}).find("up_to = 1"), std::string::npos);
  EXPECT_NE(refused({{-1.0, 1.0}}).find("above = -1"), std::string::npos);
  EXPECT_THROW((LognormalFit{exact({1.0, 2.0}), 1.0}), InputError);
}

TEST(BinomialBounds, AreThoseOfClopperAndPearson) {
  // P(X >= k | low) = P(X <= k | high) = 2.5 %.
  const auto at_most = [](int k, int n, double p) {
    double sum = 0.0;
    for (int i = 0; i <= k; ++i)
      sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) + i * std::log(p) +
                      (n - i) * std::log1p(-p));
    return sum;
  };
  for (const auto& [k, n] : {std::pair{3, 20}, std::pair{1, 5}, std::pair{19, 20}}) {
    const Bounds bounds = binomial_bounds(k, n);
    EXPECT_NEAR(1.0 - at_most(k - 1, n, bounds.low), 0.025, 1e-9);
    EXPECT_NEAR(at_most(k, n, bounds.high), 0.025, 1e-9);
  }
  EXPECT_EQ(binomial_bounds(0, 20).low, 0.0);
  EXPECT_NEAR(binomial_bounds(0, 20).high, 1.0 - std::pow(0.025, 1.0 / 20.0), 1e-12);
  EXPECT_EQ(binomial_bounds(20, 20).high, 1.0);
  EXPECT_THROW((void)binomial_bounds(3, 2), InputError);
}

}  // namespace
}  // namespace moat
