#include <gtest/gtest.h>

#include <stdexcept>

#include "elements/line/lead_rubber_bearing.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "message_of.hpp"
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
LeadRubberBearing bearing(NodeId lower, NodeId upper) {
  return {.lower = lower,
          .upper = upper,
          .yield_force = 1 * MN,
          .yield_displacement = 1 * cm,
          .post_yield_stiffness = 10 * MN / m};
}

TEST(ShearSpring, PullsTheUpperNodeBackAndTheLowerOneAlong) {
  TwoNodes nodes;
  add(nodes.model, spring(nodes.a, nodes.b));
  nodes.start();
  nodes.move(0.01, 0.03);
  EXPECT_NEAR(nodes.forces()[0], -20e3, 1e-8);
  EXPECT_NEAR(nodes.forces()[1], 20e3, 1e-8);
  expect_action_is_reaction(nodes);
  nodes.model.commit();
  const ElementBlock& block = *nodes.model.blocks()[0];
  EXPECT_NEAR(block.results().deformations[0], 0.02, 1e-15);
  EXPECT_NEAR(block.results().forces[0], 20e3, 1e-8);
  EXPECT_EQ(block.info(0).deformation_quantity, "drift");
  EXPECT_EQ(block.info(0).force_quantity, "storey_shear");
}

TEST(ShearSpring, StandsOnTheGround) {
  TwoNodes nodes;
  add(nodes.model, spring(ground, nodes.a));
  nodes.start();
  nodes.move(0.02, 1.0);
  EXPECT_EQ(nodes.forces()[1], 0.0);
  EXPECT_NEAR(nodes.forces()[2], -20e3, 1e-8);
  expect_action_is_reaction(nodes);
  expect_exact_tangent(nodes, 0.02, 1.0, 0.0, 0.0, 1e-3);
  expect_rollback(nodes, 0.02, 1.0, 0.0, 0.0);
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

TEST(LawWithoutRegimes, YieldsUnloadsAndKeepsItsSlipOnlyOnceCommitted) {
  TwoNodes nodes;
  add(nodes.model, yielding_spring(nodes.a, nodes.b));
  nodes.start();
  nodes.move(0.0, 0.05);
  EXPECT_NEAR(nodes.forces()[1], 1.4e6, 1e-6);
  nodes.move(0.0, 0.04);
  EXPECT_NEAR(nodes.forces()[1], 1.3e6, 1e-6) << "not committed: still on the backbone";
  nodes.move(0.0, 0.05);
  nodes.model.commit();
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
  nodes.model.commit();
  for (const double u : {0.06, 0.04, 0.02, -0.05}) expect_exact_tangent(nodes, 0.0, u, 0.0, 0.0, 1e-4);
  expect_rollback(nodes, 0.0, 0.045, 0.0, 0.0);
}

TEST(LeadRubberBearing, HasTheLinearStiffnessOfEachStage) {
  TwoNodes nodes;
  add(nodes.model, bearing(ground, nodes.a));
  nodes.start();
  SparseMatrix stiffness = nodes.model.linear_stiffness(StiffnessStage::initial);
  EXPECT_DOUBLE_EQ(stiffness.coeff(0, 0), 1e8);
  stiffness = nodes.model.linear_stiffness(StiffnessStage::post_yield);
  EXPECT_DOUBLE_EQ(stiffness.coeff(0, 0), 1e7);
}

TEST(LinkElements, OfOneModelActTogether) {
  TwoNodes nodes;
  add(nodes.model, yielding_spring(ground, nodes.a));
  add(nodes.model, spring(nodes.a, nodes.b));
  add(nodes.model, damper(nodes.a, nodes.b));
  nodes.start();
  expect_exact_tangent(nodes, 0.03, 0.035, 0.2, -0.1, 1e-4);
  expect_action_is_reaction(nodes);
  expect_rollback(nodes, 0.03, 0.035, 0.2, -0.1);
}

TEST(LinkElements, TheEnergiesOfABlockAreTheSumOfThoseOfItsElements) {
  TwoNodes nodes;
  ShearSpring second = spring(ground, nodes.a);
  second.name = "storey 0";
  add(nodes.model, spring(nodes.a, nodes.b));
  add(nodes.model, second);
  add(nodes.model, damper(nodes.a, nodes.b));
  add(nodes.model, yielding_spring(ground, nodes.b));
  nodes.start();
  EnergySums none;
  EXPECT_THROW(nodes.model.blocks()[0]->add_energies(none), std::logic_error) << "no accounts";
  nodes.model.start_energy_accounts();
  for (const double u : {0.01, 0.03, -0.02}) {
    nodes.move(u, 2.0 * u, 0.1, 0.4);
    nodes.model.trial().time += 0.1;
    nodes.model.evaluate_rates();
    nodes.model.commit(u > 0.02 ? WorkRule::mean_force : WorkRule::quadrature);
  }
  for (const auto& block : nodes.model.blocks()) {
    EnergySums expected, found;
    for (std::size_t e = 0; e < block->size(); ++e) expected.add(false, block->energy(e));
    block->add_energies(found);
    EXPECT_EQ(found.work, expected.work);
    EXPECT_EQ(found.stored, expected.stored);
    EXPECT_EQ(found.viscous, expected.viscous);
    EXPECT_EQ(found.hysteretic, expected.hysteretic);
    EXPECT_EQ(found.error, expected.error);
    EXPECT_NE(found.work, 0.0);
  }
}

TEST(LinkElements, OfACopiedModelAreIndependent) {
  TwoNodes nodes;
  add(nodes.model, yielding_spring(ground, nodes.a));
  nodes.start();
  TwoNodes copy{nodes};
  copy.move(0.05, 0.0);
  copy.model.commit();
  nodes.move(0.005, 0.0);
  EXPECT_NEAR(nodes.forces()[0], 0.5e6, 1e-6);
  copy.move(0.005, 0.0);
  EXPECT_LT(copy.forces()[0], 0.0);
}

TEST(LinkElements, TellWhatIsWrongWithTheirNodes) {
  TwoNodes nodes;
  EXPECT_EQ(
      message_of([&] { add(nodes.model, spring(nodes.a, nodes.a)); }),
      "ShearSpring \"storey 1\": lower and upper are the same node, \"a\". An element joins two different nodes.");
  EXPECT_EQ(message_of([&] { add(nodes.model, spring(nodes.a, NodeId{7})); }),
            "ShearSpring \"storey 1\": upper is not a node of this model. Use the NodeId that add(model, Node{...}) "
            "returned.");
  EXPECT_EQ(message_of([&] { add(nodes.model, damper(NodeId{}, nodes.a)); }),
            "ViscousDamper \"dashpot\": lower is not given. Set it to a node of this model or to `ground`.");
  LeadRubberBearing nowhere = bearing(ground, nodes.a);
  nowhere.upper = NodeId{};
  EXPECT_EQ(message_of([&] { add(nodes.model, nowhere); }),
            "LeadRubberBearing \"bearings\": upper is not given. Set it to a node of this model or to `ground`.");
}

TEST(LinkElements, TellWhichParameterIsWrong) {
  TwoNodes nodes;
  ShearSpring soft = spring(ground, nodes.a);
  soft.stiffness = -2 * N / m;
  EXPECT_EQ(message_of([&] { add(nodes.model, soft); }),
            "ShearSpring \"storey 1\": stiffness = -2 N/m is not allowed; it must be > 0 N/m and finite.");
  ViscousDamper dry = damper(ground, nodes.a);
  dry.damping = 0 * N * s / m;
  EXPECT_EQ(message_of([&] { add(nodes.model, dry); }),
            "ViscousDamper \"dashpot\": damping = 0 N s/m is not allowed; it must be > 0 N s/m and finite.");
  LeadRubberBearing stiff = bearing(ground, nodes.a);
  stiff.post_yield_stiffness = 200 * MN / m;
  EXPECT_EQ(
      message_of([&] { add(nodes.model, stiff); }),
      "LeadRubberBearing \"bearings\": post_yield_stiffness = 2e+08 N/m is not allowed; it must be below the initial "
      "stiffness yield_force / yield_displacement = 1e+08 N/m. Check the exponents of the three parameters.");
}

TEST(LinkElements, NeedANameOfTheirOwn) {
  TwoNodes nodes;
  add(nodes.model, spring(ground, nodes.a));
  EXPECT_EQ(message_of([&] { add(nodes.model, spring(nodes.a, nodes.b)); }),
            "ShearSpring \"storey 1\": an element of this name exists. Give every element its own name.");
  ViscousDamper nameless = damper(ground, nodes.a);
  nameless.name.clear();
  EXPECT_EQ(message_of([&] { add(nodes.model, nameless); }),
            "ViscousDamper: an element has no name. Give .name: results are listed under it.");
}

}  // namespace
}  // namespace moat::testing
