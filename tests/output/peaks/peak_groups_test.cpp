#include "output/peaks/peak_groups.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

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

// One digit, or two if the first is one; rounded up, across a digit where needed.
TEST(RoundedError, HasTheDigitsThatMatter) {
  for (const auto& [error, text, decimals] : {std::tuple{0.0204, "0.03", 2},
                                              {0.04, "0.04", 2},
                                              {0.0113, "0.012", 3},
                                              {0.1, "0.10", 2},
                                              {1.5, "1.5", 1},
                                              {7.2, "8", 0},
                                              {23.0, "30", -1},
                                              {123.0, "130", -1},
                                              {4001.0, "5000", -3},
                                              {0.0191, "0.02", 2},
                                              {0.0092, "0.010", 3},
                                              {9.9, "10", 0},
                                              {99.0, "100", -1}}) {
    EXPECT_EQ(rounded_error(error).text, text);
    EXPECT_EQ(rounded_error(error).decimals, decimals) << text;
  }
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
