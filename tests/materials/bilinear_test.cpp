#include <gtest/gtest.h>

#include "base/units.hpp"
#include "materials/bilinear.hpp"
#include "spring_battery.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

// The law without regimes is written independently, as a return mapping.
TEST(Bilinear, FollowsTheLawWithoutRegimes) {
  const UnlocatedBilinear unlocated{1.93e6, 0.01, 1.93e7};
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
