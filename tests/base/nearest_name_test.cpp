#include "base/nearest_name.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(NearestName, DiffersInFewLetters) {
  const std::vector<std::string> names{"name", "floor_mass", "floors", "base_mass"};
  EXPECT_EQ(nearest_name(names, "floor_masses"), "floor_mass");
  EXPECT_EQ(nearest_name(names, "flor_mass"), "floor_mass");
  EXPECT_EQ(nearest_name(names, "nam"), "name");
  EXPECT_EQ(nearest_name(names, "height"), "");
}

}  // namespace
}  // namespace moat
