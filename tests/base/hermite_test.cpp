// Polynomials over a step.
#include "base/hermite.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

// A cubic, its rate, and its ends over a step of 0.4 s that begins at 1 s.
constexpr double start = 1.0, h = 0.4;
double value(double t) { return 2.0 - 3.0 * t + 0.5 * t * t + 7.0 * t * t * t; }
double rate(double t) { return -3.0 + t + 21.0 * t * t; }

TEST(HermiteCubic, IsTheCubicThroughItsEnds) {
  const HermiteCubic cubic{value(start), rate(start), value(start + h), rate(start + h), h};
  for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(cubic.value(x), value(start + x * h), 1e-14 * value(start + h));
    EXPECT_NEAR(cubic.rate(x), rate(start + x * h), 1e-14 * rate(start + h));
  }
}

// A cubic whose rate has two zeros, one of them inside the step.
TEST(HermiteCubic, TurnsWhereItsRateIsZero) {
  for (const double inside : {1.05, 1.1, 1.35})
    for (const double outside : {-3.0, 0.9, 1.5, 7.0}) {
      const auto path = [&](double t) { return t * (t * (t / 3.0 - 0.5 * (inside + outside)) + inside * outside); };
      const auto slope = [&](double t) { return (t - inside) * (t - outside); };
      const HermiteCubic cubic{path(start), slope(start), path(start + h), slope(start + h), h};
      EXPECT_NEAR(cubic.turn(), (inside - start) / h, 1e-12) << inside << " and " << outside;
    }
}

// A quintic with its first two derivatives.
double quintic(double t) { return value(t) + t * t * t * t * (2.0 - 3.0 * t); }
double quintic_rate(double t) { return rate(t) + t * t * t * (8.0 - 15.0 * t); }
double quintic_second_rate(double t) { return 1.0 + 42.0 * t + t * t * (24.0 - 60.0 * t); }

TEST(HermiteQuintic, IsTheQuinticThroughItsEnds) {
  constexpr double end = start + h;
  const HermiteQuintic path{quintic(start),
                            quintic_rate(start),
                            quintic_second_rate(start),
                            quintic(end),
                            quintic_rate(end),
                            quintic_second_rate(end),
                            h};
  for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(path.value(x), quintic(start + x * h), 1e-13);
    EXPECT_NEAR(path.rate(x), quintic_rate(start + x * h), 1e-12);
  }
}

TEST(HermiteQuintic, ManyAtOnePlaceAreTheSame) {
  constexpr double end = start + h;
  for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const HermiteQuinticsAt quintics{x, h};
    EXPECT_NEAR(quintics.value(quintic(start), quintic_rate(start), quintic_second_rate(start), quintic(end),
                               quintic_rate(end), quintic_second_rate(end)),
                quintic(start + x * h), 1e-13);
    EXPECT_NEAR(quintics.rate(quintic(start), quintic_rate(start), quintic_second_rate(start), quintic(end),
                              quintic_rate(end), quintic_second_rate(end)),
                quintic_rate(start + x * h), 1e-12);
  }
}

}  // namespace
}  // namespace moat
