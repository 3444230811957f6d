#include "output/recorders/constant_quantities.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

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

}  // namespace
}  // namespace moat
