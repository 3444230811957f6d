// Gauss's rule with five points.

#include "base/gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

// From -1 to 2.
double integral_of_power(int power) {
  double sum = 0.0;
  Gauss::visit(-1.0, 2.0, [&](double x, double weight) { sum += weight * std::pow(x, power); });
  return sum;
}

double exact(int power) { return (std::pow(2.0, power + 1) - std::pow(-1.0, power + 1)) / (power + 1); }

TEST(Gauss, IsExactUpToTheNinthPower) {
  for (int power = 0; power <= 9; ++power)
    EXPECT_NEAR(integral_of_power(power), exact(power), 1e-13 * exact(9)) << power;
  EXPECT_GT(std::abs(integral_of_power(10) - exact(10)), 1e-4);
}

}  // namespace
}  // namespace moat
