// A quotient of two quantities of one dimension is used as the plain number it is.

#include <gtest/gtest.h>

#include <cmath>

#include "base/quantity.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

using namespace units;

constexpr Length gap = 12 * cm;

TEST(Dimensionless, ComparesWithPlainNumbers) {
  static_assert(gap / cm > 10);
  static_assert(gap / m < 1.0);
  static_assert(10.0 < gap / cm);
  static_assert(gap / gap == 1.0);
  static_assert(gap / gap == gap / gap);
  static_assert(gap / m != gap / cm);
  static_assert(gap / m <= gap / cm);
}

TEST(Dimensionless, AddsAndSubtractsPlainNumbers) {
  static_assert(gap / gap + 1.0 == 2.0);
  static_assert(1 - gap / gap == 0.0);
  static_assert(gap / gap + gap / gap == 2.0);
  static_assert((gap / gap - gap / gap) * m == 0 * m);
  Dimensionless sum = gap / gap;
  sum += 0.5;
  EXPECT_EQ(sum, 1.5);
  EXPECT_DOUBLE_EQ(std::sqrt(gap / (3 * cm)), 2.0);
}

TEST(Dimensionless, QuantitiesWithDimensionStillCompareAndAdd) {
  static_assert(gap > 1 * cm && gap == 120 * mm && gap != 1 * m);
  static_assert(gap + 8 * cm == 20 * cm || gap + 8 * cm > 19.999 * cm);
  static_assert(gap - gap == 0 * m);
}

}  // namespace
}  // namespace moat
