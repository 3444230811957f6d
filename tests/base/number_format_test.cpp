#include "base/text/number_format.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <locale>

namespace moat {
namespace {

TEST(NumberFormat, FixedHasSoManyDecimals) {
  EXPECT_EQ(to_fixed(0.125, 2), "0.12");
  EXPECT_EQ(to_fixed(-43.875, 1), "-43.9");
  EXPECT_EQ(to_fixed(1e15, 0), "1000000000000000");
  EXPECT_EQ(to_fixed(NAN, 2), "nan");
}

TEST(NumberFormat, SignificantIsThatOfPrintf) {
  EXPECT_EQ(to_significant(0.0125, 6), "0.0125");
  EXPECT_EQ(to_significant(1.0, 6), "1");
  EXPECT_EQ(to_significant(1.234e-9, 2), "1.2e-09");
  EXPECT_EQ(to_significant(123456789.0, 6), "1.23457e+08");
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(NumberFormat, DoesNotFollowTheLocaleOfTheProgram) {
  const std::locale before = std::locale::global(std::locale{std::locale::classic(), new Comma});
  EXPECT_EQ(to_fixed(0.5, 1), "0.5");
  EXPECT_EQ(to_significant(0.5, 3), "0.5");
  std::locale::global(before);
}

}  // namespace
}  // namespace moat
