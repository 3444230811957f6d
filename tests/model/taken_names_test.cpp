#include "model/taken_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace moat {
namespace {

TEST(TakenNames, RemembersEveryNameWhileItGrows) {
  TakenNames names;
  EXPECT_FALSE(names.may_contain("floor 1"));
  for (int i = 0; i < 5000; ++i) {
    const std::string name = "floor " + std::to_string(i);
    ASSERT_FALSE(names.may_contain(name)) << "a hash of 64 bits is shared by one pair in 10^12 here";
    ASSERT_TRUE(names.add(name));
    ASSERT_FALSE(names.add(name));
    ASSERT_TRUE(names.may_contain(name));
  }
  for (int i = 0; i < 5000; ++i) EXPECT_TRUE(names.may_contain("floor " + std::to_string(i)));
  EXPECT_FALSE(names.may_contain("floor 5000"));
}

TEST(TakenNames, RemembersNamesOfManyBuildingsInTurn) {
  TakenNames names;
  const auto name = [](int building, int floor) {
    return std::to_string(building) + " floor " + std::to_string(floor);
  };
  for (int floor = 1; floor <= 30; ++floor)
    for (int building = 1; building <= 40; ++building) {
      ASSERT_FALSE(names.may_contain(name(building, floor)));
      ASSERT_TRUE(names.add(name(building, floor)));
      ASSERT_FALSE(names.add(name(building, floor)));
    }
  for (int building = 1; building <= 40; ++building) {
    for (int floor = 1; floor <= 30; ++floor) EXPECT_TRUE(names.may_contain(name(building, floor)));
    EXPECT_FALSE(names.may_contain(name(building, 31)));
    EXPECT_FALSE(names.may_contain(std::to_string(building))) << "the first word alone";
  }
  EXPECT_FALSE(names.may_contain(name(41, 1)));
}

TEST(TakenNames, AreCopied) {
  TakenNames names;
  names.add("left floor 1");
  TakenNames copy = names;
  EXPECT_TRUE(copy.add("left floor 2"));
  EXPECT_TRUE(copy.add("right floor 1"));
  EXPECT_FALSE(names.may_contain("left floor 2"));
  EXPECT_FALSE(names.may_contain("right floor 1"));
  EXPECT_FALSE(names.add("left floor 1"));
}

TEST(TakenNames, AreEmptyAfterTheyWereMoved) {
  TakenNames names;
  names.add("floor 1");
  const TakenNames moved = std::move(names);
  EXPECT_TRUE(moved.may_contain("floor 1"));
  EXPECT_FALSE(names.may_contain("floor 1"));  // NOLINT(bugprone-use-after-move)
  EXPECT_TRUE(names.add("floor 1"));
}

TEST(TakenNames, TellsANameFromItsFirstWord) {
  TakenNames names;
  names.add("base");
  EXPECT_FALSE(names.may_contain("base floor"));
  names.add("left floor");
  EXPECT_FALSE(names.may_contain("left"));
  EXPECT_TRUE(names.add("left"));
  EXPECT_TRUE(names.add("left "));
  EXPECT_TRUE(names.add(" left"));
  EXPECT_FALSE(names.add("left floor"));
  EXPECT_FALSE(names.add("base"));
}

TEST(TakenNames, TakesTheEmptyNameForOneToo) {
  TakenNames names;
  names.add("");
  EXPECT_TRUE(names.may_contain(""));
}

}  // namespace
}  // namespace moat
