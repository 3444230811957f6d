// A building for which no balance of forces exists from an instant on.
#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_buildings.hpp"

namespace moat::testing {
namespace {

// Double pendulums on six storeys: one is pressed against its stop with 164 times its axial force, which falls to zero.
// Above 12 a smaller force lifts it further.
TEST(Balance, IsMissedByNameWhereAStopIsPressedUnderAWeightThatVanishes) {
  const Problem problem = building_that_overturns({.seed = 551837, .storeys = 6, .walls = false, .duration = 4.11}, {});
  Transient analysis{problem.model, problem.motion};
  EXPECT_THROW(analysis.run(), ConvergenceError);
  EXPECT_TRUE(std::ranges::any_of(analysis.warnings(), [](const std::string& each) {
    return each.starts_with("\"one\" resists with 164") && each.find("no balance of forces") != std::string::npos;
  }));
}

}  // namespace
}  // namespace moat::testing
