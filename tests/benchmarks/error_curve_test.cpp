// How the figures of ./moat bench performance are read off.

#include "measuring/error_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measuring/measure.hpp"

namespace moat::performance {
namespace {

/// Where the error falls with the square of the time, any error is read off exactly.
TEST(ReadOff, IsExactForAPowerLaw) {
  const std::vector<CurvePoint> points{{0, 1.0, 1.0}, {1, 1.0 / 16.0, 4.0}, {2, 1e-4, 100.0}};
  for (const double error : {0.5, 0.1, 0.01, 1e-4}) {
    const auto read = read_off(points, error);
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->always_better);
    EXPECT_NEAR(read->time(points[read->looser].seconds, points[read->tighter].seconds), 1.0 / std::sqrt(error), 1e-9);
  }
}

/// A setting that keeps to the error, with a tighter one that does not, is a matter of luck.
TEST(ReadOff, DoesNotCreditALuckySetting) {
  const auto read =
      read_off({{0, 0.5, 1.0}, {1, 0.001, 2.0}, {2, 0.04, 4.0}, {3, 0.0025, 16.0}, {4, 0.001, 32.0}}, 0.01);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->looser, 2u);
  EXPECT_EQ(read->tighter, 3u);
  EXPECT_NEAR(read->time(4.0, 16.0), 8.0, 1e-12);
}

TEST(ReadOff, TakesTheCheapestSettingWhereNoneIsThatBad) {
  const auto read = read_off({{7, 0.001, 2.0}, {8, 0.0005, 1.5}, {9, 0.0001, 5.0}}, 0.01);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->always_better);
  EXPECT_EQ(read->looser, 8u);
  EXPECT_EQ(read->tighter, 8u);
}

TEST(ReadOff, IsEmptyWhereTheTightestSettingIsNotThatExact) {
  EXPECT_FALSE(read_off({{0, 0.1, 1.0}}, 0.01));
  EXPECT_FALSE(read_off({{0, 0.001, 1.0}, {1, 0.1, 2.0}}, 0.01));
}

TEST(Spread, IsMedianAndQuartiles) {
  const Spread spread = spread_of({5.0, 1.0, 4.0, 2.0, 3.0});
  EXPECT_EQ(spread.median, 3.0);
  EXPECT_EQ(spread.low, 2.0);
  EXPECT_EQ(spread.high, 4.0);
  EXPECT_EQ(spread.count, 5);
}

/// A machine that runs at half speed in one round changes both times, and the ratio of no round.
TEST(Spread, OfRatiosIsTakenRoundByRound) {
  const Spread spread = ratio_of({2.0, 4.0, 2.0}, {1.0, 2.0, 1.0});
  EXPECT_EQ(spread.low, 2.0);
  EXPECT_EQ(spread.high, 2.0);
}

}  // namespace
}  // namespace moat::performance
