#include "output/peaks/peak_groups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

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

// Histories of 20 s, in rows of 10 ms.
Table histories_of(const std::vector<std::pair<std::string, std::function<double(double)>>>& deformations) {
  Table table{{{"time", "", "s", {}}}};
  for (const auto& each : deformations) table.columns.push_back({each.first, "bearings", "m", {}});
  for (int row = 0; row <= 2000; ++row) {
    table.columns[0].values.push_back(0.01 * row);
    for (std::size_t i = 0; i < deformations.size(); ++i)
      table.columns[i + 1].values.push_back(deformations[i].second(0.01 * row));
  }
  return table;
}

TEST(ResidualDisplacements, AreTheMeanOfTheLastTwoTurnsWhileTheBaseMoves) {
  // The parabola through three rows at a turn misses the cosine of 2.5 s by 3/128 A (w h)^4 at most.
  const auto swings = [](double offset, double phase) {
    return [=](double t) { return offset + 0.05 * std::cos(2.0 * std::numbers::pi * t / 2.5 + phase); };
  };
  std::vector<Peak> residual = residual_displacements(histories_of({{"isolator_deformation", swings(-0.02, 0.4)}}));
  ASSERT_EQ(residual.size(), 1u);
  EXPECT_EQ(residual[0].quantity, "residual_displacement");
  EXPECT_EQ(residual[0].where, "bearings");
  EXPECT_NEAR(residual[0].value, -0.02, 1e-9);
  EXPECT_EQ(residual[0].side, "still moving");
  EXPECT_EQ(residual[0].time, 20.0);
  residual = residual_displacements(histories_of({{"isolator_deformation", [](double) { return 0.07; }},
                                                  {"isolator_deformation_x", swings(-0.03, 1.0)},
                                                  {"isolator_deformation_y", swings(0.04, 2.0)}}));
  ASSERT_EQ(residual.size(), 1u);
  EXPECT_NEAR(residual[0].value, 0.05, 1e-9);
}

TEST(ResidualDisplacements, AreTheEndWhereTheBaseHasComeToRest) {
  // It slides to its last turn at 6 s, comes back until 7 s, and stays; slow creep of 0.05 mm/s is rest.
  const auto stops = [](double t) { return t < 7.0 ? 0.03 * std::cos(std::numbers::pi * t / 1.5) : 0.03 * -0.5; };
  const auto creeps = [&](double t) { return stops(t) + (t > 7.0 ? 5e-5 * (t - 7.0) : 0.0); };
  const auto never_turns = [](double t) { return 0.01 * t; };
  const auto residual = [](const std::function<double(double)>& deformation) {
    return residual_displacements(histories_of({{"isolator_deformation", deformation}})).front();
  };
  EXPECT_EQ(residual(stops).value, -0.015);
  EXPECT_EQ(residual(stops).side, "");
  EXPECT_NEAR(residual(creeps).value, -0.015 + 5e-5 * 13.0, 1e-15);
  EXPECT_NEAR(residual(never_turns).value, 0.2, 1e-15);
  EXPECT_TRUE(residual_displacements({}).empty());
}

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
