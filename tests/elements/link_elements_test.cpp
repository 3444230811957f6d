#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "message_of.hpp"
#include "moat.hpp"
#include "two_nodes.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing {
namespace {

using namespace units;

ShearSpring spring(NodeId lower, NodeId upper) {
  return {.name = "storey 1", .lower = lower, .upper = upper, .stiffness = 1 * MN / m};
}
ViscousDamper damper(NodeId lower, NodeId upper) {
  return {.name = "dashpot", .lower = lower, .upper = upper, .damping = 50 * kN * s / m};
}
// Both yield at 1 cm and 1 MN; then they are a tenth as stiff. The first needs no change of regime.
Spring<UnlocatedBilinear> yielding_spring(NodeId lower, NodeId upper) {
  return {.name = "spring", .lower = lower, .upper = upper, .law = {1e6, 0.01, 10e6}};
}
TEST(ShearSpring, PullsTheUpperNodeBackAndTheLowerOneAlong) {
  TwoNodes nodes;
  add(nodes.model, spring(nodes.a, nodes.b));
  nodes.start();
  nodes.move(0.01, 0.03);
  EXPECT_NEAR(nodes.forces()[0], -20e3, 1e-8);
  EXPECT_NEAR(nodes.forces()[1], 20e3, 1e-8);
  expect_action_is_reaction(nodes);
  nodes.state->commit();
  EXPECT_NEAR(nodes.state->elements(0).results()[0].deformation, 0.02, 1e-15);
  EXPECT_NEAR(nodes.state->elements(0).results()[0].force, 20e3, 1e-8);
  const ElementInfo& info = nodes.model.blocks()[0]->info(0);
  EXPECT_EQ(info.deformation_quantity, "drift");
  EXPECT_EQ(info.force_quantity, "storey_shear");
}

TEST(ViscousDamper, ResistsTheDifferenceOfVelocities) {
  TwoNodes nodes;
  add(nodes.model, damper(nodes.a, nodes.b));
  nodes.start();
  nodes.move(0.5, -0.5, 0.1, 0.4);
  EXPECT_NEAR(nodes.forces()[0], -15e3, 1e-8);
  EXPECT_NEAR(nodes.forces()[1], 15e3, 1e-8);
  expect_action_is_reaction(nodes);
  expect_exact_tangent(nodes, 0.5, -0.5, 0.1, 0.4, 1e-3);
  expect_rollback(nodes, 0.5, -0.5, 0.1, 0.4);
}

// While the rate grows linearly the power is a parabola, whose integral Simpson's rule gives: c h/3 (v0^2 + v0 v1 +
// v1^2).
TEST(Viscous, DissipatesTheIntegralOfItsPower) {
  constexpr double c = 50e3, h = 0.1, v1 = 0.3, v2 = -0.1;  // N s/m, s, m/s
  TwoNodes nodes;
  add(nodes.model,
      Spring<Viscous>{.name = "dashpot", .lower = ground, .upper = nodes.a, .law = {.damping = c * N * s / m}});
  nodes.start();
  nodes.state->start_energy_accounts();
  const double d1 = 0.5 * h * v1, d2 = d1 + 0.5 * h * (v1 + v2);
  move_to(*nodes.state, Vector{{d1}}, Vector{{v1}}, h);
  nodes.state->commit(WorkRule::mean_force);
  EXPECT_NEAR(nodes.state->elements(0).energy(0).dissipated, c * h / 3.0 * v1 * v1, 1e-12 * c);
  move_to(*nodes.state, Vector{{d2}}, Vector{{v2}}, h);
  nodes.state->commit(WorkRule::mean_force);
  EXPECT_NEAR(nodes.state->elements(0).energy(0).dissipated, c * h / 3.0 * (2.0 * v1 * v1 + v1 * v2 + v2 * v2),
              1e-12 * c);
}

TEST(LawWithoutRegimes, YieldsUnloadsAndKeepsItsSlipOnlyOnceCommitted) {
  TwoNodes nodes;
  add(nodes.model, yielding_spring(nodes.a, nodes.b));
  nodes.start();
  nodes.move(0.0, 0.05);
  EXPECT_NEAR(nodes.forces()[1], 1.4e6, 1e-6);
  nodes.move(0.0, 0.04);
  EXPECT_NEAR(nodes.forces()[1], 1.3e6, 1e-6) << "not committed: still on the backbone";
  nodes.move(0.0, 0.05);
  nodes.state->commit();
  nodes.move(0.0, 0.04);
  EXPECT_NEAR(nodes.forces()[1], 0.4e6, 1e-6) << "committed: unloads with the initial stiffness";
  expect_action_is_reaction(nodes);
}

TEST(LawWithoutRegimes, HasExactTangentsOnEveryBranch) {
  TwoNodes nodes;
  add(nodes.model, yielding_spring(ground, nodes.b));
  nodes.start();
  for (const double u : {0.005, 0.02, -0.03}) expect_exact_tangent(nodes, 0.0, u, 0.0, 0.0, 1e-4);
  nodes.move(0.0, 0.05);
  nodes.state->commit();
  for (const double u : {0.06, 0.04, 0.02, -0.05}) expect_exact_tangent(nodes, 0.0, u, 0.0, 0.0, 1e-4);
  expect_rollback(nodes, 0.0, 0.045, 0.0, 0.0);
}

TEST(LinkElements, TellWhichParameterIsWrong) {
  TwoNodes nodes;
  ShearSpring soft = spring(ground, nodes.a);
  soft.stiffness = -2 * N / m;
  EXPECT_EQ(message_of([&] { add(nodes.model, soft); }),
            "ShearSpring \"storey 1\": stiffness = -2 N/m is not allowed; it must be > 0 N/m and finite. Check its "
            "sign and its unit.");
  ViscousDamper dry = damper(ground, nodes.a);
  dry.damping = 0 * N * s / m;
  EXPECT_EQ(message_of([&] { add(nodes.model, dry); }),
            "ViscousDamper \"dashpot\": damping = 0 N s/m is not allowed; it must be > 0 N s/m and finite. Check its "
            "sign and its unit.");
  LeadRubberBearing weak{
      .upper = nodes.a, .yield_force = 0 * N, .yield_displacement = 1 * cm, .post_yield_stiffness = 10 * MN / m};
  EXPECT_EQ(message_of([&] { add(nodes.model, weak); }),
            "LeadRubberBearing \"bearings\": yield_force = 0 N is not allowed; it must be > 0 N and finite. Check its "
            "sign and its unit.");
}

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

TEST(LeadRubberBearing, ADesignTakesTheWeightOfItsBuilding) {
  Model model;
  add(model, ShearBuilding{.storeys = 3,
                           .floor_mass = 500 * tonne,
                           .storey_stiffness = 1 * GN / m,
                           .base_mass = 550 * tonne,
                           .isolation = BearingDesign{
                               .strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 15 * mm}});
  const auto found = std::ranges::find_if(
      model.blocks(), [](const auto& block) { return block->size() > 0 && block->info(0).isolates; });
  ASSERT_NE(found, model.blocks().end());
  const ElementBlock& bearings = **found;
  const double mass = 2050e3, stiffness = bearings.linear_stiffness(0, StiffnessStage::post_yield);
  EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(mass / stiffness), 3.0, 1e-12);
  const double yield_force = bearings.law_of_block(0).parameters[0].value;
  EXPECT_NEAR((yield_force - 0.015 * stiffness) / (mass * standard_gravity), 0.06, 1e-12);
  EXPECT_EQ(bearings.law(0).name, "BearingDesign");
  EXPECT_EQ(bearings.law(0).parameters[0].value, 0.06) << "reports show the design as it was given";
}

TEST(LeadRubberBearing, RefusesADesignWithoutOneStrength) {
  BearingDesign both = design;
  both.strength_ratio = 0.06;
  const std::string message =
      "LeadRubberBearing::from_design: characteristic_strength and strength_ratio are both given, or neither. Give one "
      "of them.";
  EXPECT_EQ(message_of([&] { static_cast<void>(LeadRubberBearing::from_design(both)); }), message);
  BearingDesign percent = both;
  percent.characteristic_strength = {};
  percent.strength_ratio = 6.0;
  EXPECT_EQ(
      message_of([&] { static_cast<void>(LeadRubberBearing::from_design(percent)); }),
      "LeadRubberBearing::from_design: strength_ratio = 6 is not allowed; it must be > 0 and < 1. 6 % of the weight "
      "is 0.06.");
  percent.strength_ratio = 0.0;
  EXPECT_EQ(message_of([&] { static_cast<void>(LeadRubberBearing::from_design(percent)); }), message);
}

TEST(LeadRubberBearing, RefusesADesignThatIsNotPositive) {
  BearingDesign bad = design;
  bad.isolation_period = 0 * s;
  EXPECT_EQ(message_of([&] { static_cast<void>(LeadRubberBearing::from_design(bad)); }),
            "LeadRubberBearing::from_design: isolation_period = 0 s is not allowed; it must be > 0 s and finite. Check "
            "its sign and its unit.");
}

}  // namespace
}  // namespace moat::testing
