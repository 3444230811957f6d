// The recipe "How to add an element" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include "elements/line/cable.hpp"
#include "ended_case.hpp"
#include "message_of.hpp"
#include "small_models.hpp"

namespace moat::testing {
namespace {

using namespace units;

Model mass_on_a_cable(Length slack) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 100 * kg, .initial_velocity = 1 * m / s});
  add(model, Cable{.name = "cable", .lower = ground, .upper = node, .stiffness = 10 * kN / m, .slack = slack});
  return model;
}

// A free mass tightens the cable and leaves it with the same speed: v sqrt(m/k) is the largest stretch.
TEST(ElementRecipe, PullsAndNeverPushes) {
  const Model model = mass_on_a_cable(5 * cm);
  const auto [result, state] = run_to_end(model, still_ground(0.8 * s), {.transient = {.tolerance = 1e-7}});
  EXPECT_NEAR(state.velocity(NodeId{0}), -1.0, 1e-3);
  const auto force = std::ranges::find(result.peaks, "cable_force", &Peak::quantity);
  ASSERT_NE(force, result.peaks.end());
  EXPECT_NEAR(force->magnitude(), std::sqrt(100.0 * 1e4), 1.0);
}

TEST(ElementRecipe, RefusesABadParameter) {
  EXPECT_EQ(
      message_of([] { mass_on_a_cable(-1 * cm); }),
      "Cable \"cable\": slack = -0.01 m is not allowed; it must be >= 0 m and finite. Check its sign and its unit.");
}

}  // namespace
}  // namespace moat::testing
