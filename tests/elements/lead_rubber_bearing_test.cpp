#include "elements/line/lead_rubber_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const BearingDesign design{
    .weight = 30 * MN, .characteristic_strength = 1.5 * MN, .isolation_period = 2.5 * s, .yield_displacement = 1 * cm};

TEST(LeadRubberBearing, OfADesignHasItsPeriodAndItsStrength) {
  const LeadRubberBearing bearing = LeadRubberBearing::from_design(design);
  const double mass = 30e6 / 9.80665, stiffness = bearing.post_yield_stiffness.si();
  EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(mass / stiffness), 2.5, 1e-12);
  // On the post-yield branch, back at zero displacement, the force is the characteristic strength.
  EXPECT_NEAR(bearing.yield_force.si() - stiffness * bearing.yield_displacement.si(), 1.5e6, 1e-6);
  EXPECT_EQ(bearing.yield_displacement.si(), 0.01);
}

TEST(LeadRubberBearing, RefusesADesignThatIsNotPositive) {
  BearingDesign bad = design;
  bad.isolation_period = 0 * s;
  EXPECT_EQ(message_of([&] { static_cast<void>(LeadRubberBearing::from_design(bad)); }),
            "LeadRubberBearing::from_design: isolation_period = 0 s is not allowed; it must be > 0 s and finite.");
}

}  // namespace
}  // namespace moat
