#include "output/peaks/peak_groups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace moat {
namespace {

TEST(IsolatorsAtTheEnd, AreTheLastRowOfTheirDeformations) {
  const Table histories{.columns = {{"time", "", "s", {0.0, 0.5, 1.0}},
                                    {"drift", "storey 1", "m", {0.0, 0.1, 0.2}},
                                    {"isolator_deformation", "west", "m", {0.0, 0.3, -0.04}},
                                    {"isolator_deformation", "east", "m", {0.0, 0.3, 0.05}}}};
  const std::vector<Peak> ends = isolators_at_the_end(histories);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].where, "west");
  EXPECT_EQ(ends[0].value, -0.04);
  EXPECT_EQ(ends[0].time, 1.0);
  EXPECT_EQ(ends[1].value, 0.05);
}

TEST(IsolatorsAtTheEnd, AreNoneWithoutHistories) { EXPECT_TRUE(isolators_at_the_end({}).empty()); }

TEST(ConstantQuantities, NeverChangeAtAnyPlaceAndAreNotZero) {
  const Table histories{.columns = {{"time", "", "s", {0.0, 0.5}},
                                    {"friction_coefficient", "west", "1", {0.05, 0.05}},
                                    {"friction_coefficient", "east", "1", {0.08, 0.08}},
                                    {"temperature", "west", "K", {293.0, 293.0}},
                                    {"temperature", "east", "K", {293.0, 294.0}},
                                    {"impact_force", "moat", "N", {0.0, 0.0}}}};
  EXPECT_EQ(constant_quantities(histories), std::set<std::string>{"friction_coefficient"});
}

TEST(ConstantQuantities, AreNotSeenInOneRow) {
  EXPECT_TRUE(constant_quantities({.columns = {{"friction_coefficient", "west", "1", {0.05}}}}).empty());
  EXPECT_TRUE(constant_quantities({}).empty());
}

TEST(RoundedError, HasOneDigitOrTwoIfTheFirstIsOne) {
  EXPECT_EQ(rounded_error(0.0204).text, "0.03");
  EXPECT_EQ(rounded_error(0.04).text, "0.04");
  EXPECT_EQ(rounded_error(0.0113).text, "0.012");
  EXPECT_EQ(rounded_error(0.1).text, "0.10");
  EXPECT_EQ(rounded_error(1.5).text, "1.5");
  EXPECT_EQ(rounded_error(7.2).text, "8");
  EXPECT_EQ(rounded_error(23.0).text, "30");
  EXPECT_EQ(rounded_error(123.0).text, "130");
  EXPECT_EQ(rounded_error(4001.0).text, "5000");
}

TEST(RoundedError, GoesUpAcrossADigit) {
  EXPECT_EQ(rounded_error(0.0191).text, "0.02");
  EXPECT_EQ(rounded_error(0.0092).text, "0.010");
  EXPECT_EQ(rounded_error(9.9).text, "10");
  EXPECT_EQ(rounded_error(99.0).text, "100");
}

TEST(RoundedError, GivesTheDecimalsOfItsLastDigit) {
  EXPECT_EQ(rounded_error(0.0204).decimals, 2);
  EXPECT_EQ(rounded_error(0.0113).decimals, 3);
  EXPECT_EQ(rounded_error(1.5).decimals, 1);
  EXPECT_EQ(rounded_error(7.2).decimals, 0);
  EXPECT_EQ(rounded_error(123.0).decimals, -1);
  EXPECT_EQ(rounded_error(4001.0).decimals, -3);
}

TEST(RoundedError, IsNeverBelowTheError) {
  for (double error = 1e-9; error < 1e9; error *= 1.037) {
    const double printed = std::stod(rounded_error(error).text);
    EXPECT_GE(printed, error * (1.0 - 1e-9));
    EXPECT_LE(printed, error * 1.5) << "2.01 becomes 3";
  }
}

TEST(RoundedError, IsShortWhereItIsVerySmall) {
  EXPECT_EQ(rounded_error(0.0000021).text, "0.000003");
  EXPECT_EQ(rounded_error(2.1e-9).text, "3e-09");
}

TEST(RoundedError, LeavesAllDigitsWhereThereIsNone) {
  EXPECT_EQ(rounded_error(0.0).text, "0");
  EXPECT_GT(rounded_error(0.0).decimals, 20);
  EXPECT_EQ(rounded_error(std::numeric_limits<double>::quiet_NaN()).text, "");
  EXPECT_GT(rounded_error(std::numeric_limits<double>::quiet_NaN()).decimals, 20);
}

TEST(RoundedTo, RoundsBeforeThePoint) {
  EXPECT_EQ(rounded_to(2563.0, -1), 2560.0);
  EXPECT_EQ(rounded_to(2563.0, -3), 3000.0);
  EXPECT_EQ(rounded_to(25.63, 1), 25.63);
}

}  // namespace
}  // namespace moat
