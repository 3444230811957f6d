#include "base/text/nearest_name.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace moat {
namespace {

TEST(NearestName, DiffersInFewLetters) {
  const std::vector<std::string> names{"name", "floor_mass", "floors", "base_mass"};
  EXPECT_EQ(nearest_name(names, "floor_masses"), "floor_mass");
  EXPECT_EQ(nearest_name(names, "flor_mass"), "floor_mass");
  EXPECT_EQ(nearest_name(names, "nam"), "name");
  EXPECT_EQ(nearest_name(names, "height"), "");
  EXPECT_EQ(nearest_name({}, "height"), "");
}

TEST(NearestName, IsFoundForTypingMistakes) {
  const std::vector<std::string> options{"gap", "out", "step", "record", "record-unit", "project", "frame-interval"};
  for (const auto& [misspelt, meant] :
       std::vector<std::pair<std::string, std::string>>{{"gab", "gap"},
                                                        {"gapp", "gap"},
                                                        {"otu", "out"},
                                                        {"recrod", "record"},
                                                        {"recordunit", "record-unit"},
                                                        {"projekt", "project"},
                                                        {"frame_intervall", "frame-interval"}})
    EXPECT_EQ(nearest_name(options, misspelt), meant) << misspelt;
}

TEST(NearestName, StandsInAQuestion) {
  EXPECT_EQ(did_you_mean({"gap", "out"}, "gab", "--"), " Did you mean --gap?");
  EXPECT_EQ(did_you_mean({"run", "new"}, "rum"), " Did you mean run?");
  EXPECT_EQ(did_you_mean({"run", "new"}, "bogus"), "");
}

TEST(NearestName, IsNoOtherWord) {
  const std::vector<std::string> options{"out", "step", "end", "gap", "force", "hardening_stiffness"};
  for (const std::string other : {"bogus", "storeys", "seed", "case", "colour", "in", "", "x", "damping_stiffness"})
    EXPECT_EQ(nearest_name(options, other), "") << other;
}

}  // namespace
}  // namespace moat
