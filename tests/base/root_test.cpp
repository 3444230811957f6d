#include "base/root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moat {
namespace {

TEST(RootBetween, FindsRootsToTheirLastDigits) {
  EXPECT_NEAR(root_between([](double x) { return x * x - 2.0; }, 0.0, 2.0), std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(root_between([](double x) { return std::cos(x); }, 1.5, 3.0), std::numbers::pi / 2.0, 1e-15);
}

TEST(RootBetween, FindsRootsOfAnyOrderOfMagnitude) {
  for (const double root : {1e-200, 1e-12, 1.0, 1e12})
    EXPECT_NEAR(root_between([root](double x) { return std::tanh(std::log(x / root)); }, 1e-3 * root, 1e6 * root), root,
                1e-14 * root);
}

TEST(RootBetween, TakesAnEndWhereTheFunctionIsZero) {
  EXPECT_EQ(root_between([](double x) { return x; }, 0.0, 1.0), 0.0);
  EXPECT_EQ(root_between([](double x) { return x - 1.0; }, 0.0, 1.0), 1.0);
}

TEST(BracketRoot, KeepsTheRootBetweenItsEnds) {
  const auto cube = [](double x) { return x * x * x - 0.3; };
  const Bracket bracket = bracket_root(cube, 0.0, 1.0, 1e-6);
  EXPECT_LE(cube(bracket.low), 0.0);
  EXPECT_GE(cube(bracket.high), 0.0);
  EXPECT_LE(bracket.high - bracket.low, 1e-6);
}

TEST(BracketRoot, RefusesAnIntervalWithoutAChangeOfSign) {
  EXPECT_THROW(bracket_root([](double x) { return 1.0 + x * x; }, -1.0, 1.0), std::logic_error);
}

}  // namespace
}  // namespace moat
