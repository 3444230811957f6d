#include "report/charts/round_factor.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(RoundFactor, IsTheLargestRoundOneBelow) {
  for (const auto& [value, expected] :
       {std::pair{1.0, 1.0}, {1.99, 1.0}, {2.0, 2.0}, {4.9, 2.0}, {7.0, 5.0}, {12.0, 10.0}, {499.0, 200.0}})
    EXPECT_EQ(round_factor(value), expected) << value;
}

TEST(RoundFactor, NeverMakesSmaller) {
  for (const double value : {0.5, 0.0, -3.0, std::nan("")}) EXPECT_EQ(round_factor(value), 1.0) << value;
}

}  // namespace
}  // namespace moat
