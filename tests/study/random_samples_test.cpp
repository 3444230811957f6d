// Parameters drawn at random follow their distributions.

#include "study/random_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using testing::message_of;

const std::vector<RandomVariable> variables{
    {.name = "gap", .unit = "cm", .distribution = UniformDistribution{10.0, 30.0}},
    {.name = "offset", .unit = "cm", .distribution = NormalDistribution{-2.0, 3.0}},
    {.name = "friction", .unit = "", .distribution = LognormalDistribution{0.05, 0.4}}};

// Distribution function of each variable.
double share(std::size_t variable, double x) {
  const auto normal = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
  if (variable == 0) return (x - 10.0) / 20.0;
  return variable == 1 ? normal((x + 2.0) / 3.0) : normal(std::log(x / 0.05) / 0.4);
}

// Largest distance between the empirical and the true distribution function, times sqrt(n).
double kolmogorov(std::size_t variable, std::vector<double> values) {
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double p = share(variable, values[i]), below = static_cast<double>(i) / n;
    largest = std::max({largest, std::abs(p - below), std::abs(p - below - 1.0 / n)});
  }
  return largest * std::sqrt(n);
}

TEST(RandomSamples, FollowTheirDistributions) {
  for (const Sampling sampling : {Sampling::independent, Sampling::latin_hypercube})
    for (const std::uint64_t seed : {1u, 2u, 77u}) {
      const StudyCases cases = random_samples(variables, 4000, seed, sampling);
      ASSERT_EQ(cases.count(), 4000u);
      // Exceeded by one independent sample in 1e5 (Kolmogorov's distribution: 2 exp(-2 x^2)).
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(kolmogorov(i, cases.axes()[i].values), 2.47) << i;
    }
}

TEST(RandomSamples, OfALatinHypercubeHaveOneInEveryInterval) {
  const StudyCases cases = random_samples(variables, 50, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    std::set<int> intervals;
    for (const double x : cases.axes()[i].values) intervals.insert(static_cast<int>(50.0 * share(i, x)));
    EXPECT_EQ(intervals.size(), 50u) << i;
    EXPECT_EQ(*intervals.begin(), 0) << i;
    EXPECT_EQ(*intervals.rbegin(), 49) << i;
  }
}

TEST(RandomSamples, DependOnTheSeedAlone) {
  const auto values = [](std::uint64_t seed) { return random_samples(variables, 20, seed).axes()[2].values; };
  EXPECT_EQ(values(5), values(5));
  EXPECT_NE(values(5), values(6));
}

TEST(RandomSamples, AreNotPairedInOrder) {
  // Correlation of ranks: zero on average, with a standard deviation of 1/sqrt(n - 1).
  const StudyCases cases = random_samples(variables, 1000, 9);
  double sum = 0.0;
  for (std::size_t i = 0; i < 1000; ++i)
    sum += (share(0, cases.axes()[0].values[i]) - 0.5) * (share(1, cases.axes()[1].values[i]) - 0.5);
  EXPECT_LT(std::abs(sum / 1000.0 * 12.0), 4.5 / std::sqrt(999.0));
}

TEST(RandomSamples, RefuseParametersOutsideTheirRange) {
  const auto refused = [](const auto& distribution) {
    return message_of<InputError>(
        [&] { (void)random_samples({{.name = "gap", .unit = "cm", .distribution = distribution}}, 5, 1); });
  };
  EXPECT_NE(refused(UniformDistribution{3.0, 3.0}).find("RandomVariable \"gap\": low is not below high"),
            std::string::npos);
  EXPECT_NE(refused(NormalDistribution{0.0, -1.0}).find("standard_deviation = -1"), std::string::npos);
  EXPECT_NE(refused(LognormalDistribution{0.0, 0.3}).find("median = 0"), std::string::npos);
  EXPECT_NE(message_of<InputError>([] { (void)random_samples(variables, 0, 1); }).find("count = 0"), std::string::npos);
}

}  // namespace
}  // namespace moat
