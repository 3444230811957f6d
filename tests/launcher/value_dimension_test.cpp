#include "launcher/value_dimension.hpp"

#include <gtest/gtest.h>

namespace moat::launcher {
namespace {

TEST(ValueDimension, IsThatOfTheProduct) {
  EXPECT_EQ(type_of_product("100 * MN"), "Quantity<1, 2, -2>");
  EXPECT_EQ(type_of_product("-2.95e-9*N / m_3_2"), "Quantity<1, -1, -2>");
  EXPECT_EQ(type_of_product("2 * pi * m / s"), "Quantity<0, 2, -1>");
  EXPECT_EQ(type_of_product("1'000"), "int");
  EXPECT_EQ(type_of_product("5.0"), "double");
  EXPECT_EQ(type_of_product(".5"), "double");
  EXPECT_EQ(type_of_product("10 * cm / m"), "double");
}

TEST(ValueDimension, IsUnknownForOtherExpressions) {
  for (const char* value : {"", "gap", "2 * gap", "1 * m + 2 * m", "f(1)", "3 *", "{1 * m}", "\"5\"", "10 cm"})
    EXPECT_EQ(type_of_product(value), "") << value;
}

TEST(ValueDimension, KnowsNumbers) {
  for (const char* value : {"5", "5.", "-.5", "1e6", "+2.5e-3", "1'000.5"}) EXPECT_TRUE(is_number(value)) << value;
  for (const char* value : {"", "m", "5 * m", "1e", "."}) EXPECT_FALSE(is_number(value)) << value;
}

}  // namespace
}  // namespace moat::launcher
