#include <gtest/gtest.h>

#include "base/units.hpp"
#include "materials/bilinear.hpp"
#include "spring_battery.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double yield = 0.01, sliding = 1.93e8 - 1.93e7;  // m, N/m
const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

TEST(Bilinear, HasTheLoopAreaOfTheClosedForm) {
  for (const double amplitude : {0.9 * yield, 0.012, 0.05, 0.2}) {
    LawPath<Bilinear> path{bearing};
    path.move(amplitude, 1.0);
    const double before = path.work();
    for (const double target : {-amplitude, amplitude}) path.move(target, 1.0);
    EXPECT_NEAR(path.work() - before, 4.0 * sliding * yield * std::max(amplitude - yield, 0.0), 1e-3) << amplitude;
  }
}

// The law without regimes is written independently, as a return mapping.
TEST(Bilinear, FollowsTheLawWithoutRegimes) {
  const UnlocatedBilinear unlocated{1.93e6, yield, 1.93e7};
  UnlocatedBilinear::State plain, after;
  LawPath<Bilinear> path{bearing, 0};
  RandomMoves moves{{.deformation = 0.1}};
  for (int i = 0; i < 60000; ++i) {
    const double target = moves.target(path.deformation());
    path.move(target, 1.0);
    ASSERT_NEAR(path.force(), unlocated.evaluate(plain, target, 0.0, after).force, 1e-8 * 1.93e6) << i;
    plain = after;
  }
}

}  // namespace
}  // namespace moat::testing
