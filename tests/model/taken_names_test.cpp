#include "model/taken_names.hpp"

#include <gtest/gtest.h>

#include <string>

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

TEST(TakenNames, TakesTheEmptyNameForOneToo) {
  TakenNames names;
  names.add("");
  EXPECT_TRUE(names.may_contain(""));
}

}  // namespace
}  // namespace moat
