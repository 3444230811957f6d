// moat.hpp alone declares all functions that the documentation names.

#include <moat.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

using namespace units;

TEST(MoatHeader, GivesTheLawsASpringCanHave) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
  add(model, Spring<Linear>{.name = "linear", .lower = ground, .upper = body, .law = {.stiffness = 1 * MN / m}});
  add(model, Spring<Viscous>{.name = "viscous", .lower = ground, .upper = body, .law = {.damping = 1 * kN * s / m}});
  const Bilinear fuse{.yield_force = 10 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 50 * kN / m};
  add(model, Spring<Bilinear>{.name = "bilinear", .lower = ground, .upper = body, .law = fuse});
  // 1 MN/m and 10 kN/cm.
  const std::vector<NamedPeriod> periods = characteristic_periods(model);
  ASSERT_EQ(periods.size(), 1u);
  EXPECT_NEAR(periods[0].value, 2.0 * std::acos(-1.0) * std::sqrt(1e3 / 2e6), 1e-9);
}

TEST(MoatHeader, GivesSpectra) {
  const GroundMotion motion = near_fault_pulse();
  EXPECT_DOUBLE_EQ(response_spectrum(motion, {0 * s, 1 * s}, 0.05).absolute_acceleration[0],
                   motion.peak_acceleration().si());
}

}  // namespace
}  // namespace moat
