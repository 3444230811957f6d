#include "output/recorders/at_the_end.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace moat
