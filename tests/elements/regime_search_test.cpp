// Where functions fall.

#include "elements/block/regime_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace moat {
namespace {

constexpr double close = 1e-15;

TEST(FirstFall, IsBehindTheRootAndCloseToIt) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> uniform{0.0, 1.0};
  for (int count = 0; count < 1000; ++count) {
    const double root = uniform(random), beyond = root + (1.0 - root) * uniform(random),
                 power = 0.2 + 3.0 * uniform(random), factor = std::pow(10.0, 20.0 * uniform(random) - 10.0);
    int evaluations = 0;
    const auto function = [&](double x) {
      ++evaluations;
      return factor * (std::pow(root, power) - std::pow(x, power));
    };
    const double found = first_fall(function, beyond, 0.0);
    EXPECT_LE(function(found), 0.0);
    EXPECT_NEAR(found, root, 2.0 * close) << root << " to the power of " << power;
    EXPECT_LE(evaluations, 90) << root << " to the power of " << power;
  }
}

TEST(FirstFall, ToAnAimBelowZero) {
  EXPECT_NEAR(first_fall([](double x) { return 0.3 - x * x; }, 1.0, -0.06), 0.6, 2.0 * close);
}

TEST(FirstFall, OfAFunctionThatJumps) {
  for (const double place : {1e-3, 0.3, 0.9999}) {
    const double found = first_fall([&](double x) { return x < place ? 1e-9 : -1e9; }, 1.0, 0.0);
    EXPECT_GE(found, place);
    EXPECT_NEAR(found, place, 2.0 * close);
  }
}

TEST(FirstFall, AtTheEnds) {
  EXPECT_EQ(first_fall([](double x) { return 2.0 - x; }, 0.7, 0.0), 0.7);
  EXPECT_EQ(first_fall([](double x) { return -x; }, 0.7, 0.0), 0.0);
  EXPECT_EQ(first_fall([](double x) { return -1.0 - x; }, 0.7, 0.0), 0.0);
}

// A law may give such values far beyond its margin.
TEST(FirstFall, EndsWhereAFunctionIsNoNumberOrInfinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), -infinity}) {
    const double found = first_fall([&](double x) { return x < 0.25 ? 1.0 : x < 1.0 ? value : -1.0; }, 1.0, 0.0);
    EXPECT_NEAR(found, 0.25, 2.0 * close);
  }
}

TEST(FallNear, IsTheRootOfAParabolaOnBothSides) {
  for (const double root : {-3e-3, -1e-6, 1e-7, 2e-4, 4e-3})
    for (const double bend : {-20.0, 0.0, 20.0}) {
      const auto function = [&](double time) { return (root - time) * (0.5 + bend * (time + root)); };
      EXPECT_NEAR(fall_near(function), root, 2.0 * close) << "bend " << bend;
    }
}

TEST(FallNear, IsInfiniteForAFunctionThatDoesNotFall) {
  EXPECT_TRUE(std::isinf(fall_near([](double time) { return 1.0 + time; })));
  EXPECT_TRUE(std::isinf(fall_near([](double) { return -1.0; })));
}

}  // namespace
}  // namespace moat
