#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "message_of.hpp"
#include "two_nodes.hpp"

namespace moat::testing {
namespace {

using namespace units;

template <class Law>
Gap<Law> gap_between(NodeId left, NodeId right, Law law) {
  return {.name = "gap", .left = left, .right = right, .clearance = 10 * cm, .law = law};
}

const HertzDamp hertz_damp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};
const LinearElastic elastic{.stiffness = 1e8 * N / m};

// Brings the contact to the committed state at the given motion, into the regime that belongs there.
void commit_at(TwoNodes& nodes, double ua, double ub, double va, double vb) {
  nodes.move(ua, ub, va, vb);
  commit_with_regimes(*nodes.state);
}

TEST(Gap, DoesNothingWhileItIsOpen) {
  TwoNodes nodes;
  add(nodes.model, gap_between(nodes.a, nodes.b, hertz_damp));
  nodes.start();
  nodes.move(0.05, -0.0499, 1.0, -1.0);
  EXPECT_EQ(nodes.forces(), Eigen::Vector3d::Zero());
  EXPECT_NEAR(nodes.state->elements(0).results()[0].deformation, -1e-4, 1e-15);
}

TEST(Gap, PushesTheLeftNodeLeftAndTheRightNodeRight) {
  TwoNodes nodes;
  add(nodes.model, gap_between(nodes.a, nodes.b, elastic));
  nodes.start();
  commit_at(nodes, 0.06, -0.04 - 1e-9, 0.5, 0.0);
  nodes.move(0.06, -0.05);
  // Internal forces act on the structure's side of the balance M a + f = 0: f > 0 accelerates to the left.
  EXPECT_NEAR(nodes.forces()[0], 1e6, 1e-3);
  EXPECT_NEAR(nodes.forces()[1], -1e6, 1e-3);
  expect_action_is_reaction(nodes);
  EXPECT_NEAR(nodes.state->elements(0).results()[0].force, 1e6, 1e-3) << "compression is reported positive";
}

TEST(Gap, ReportsTheTrueApproachSpeedWhereTheLawCountsMore) {
  for (const double speed : {5e-5, 0.0, -0.2}) {
    TwoNodes nodes;
    add(nodes.model, gap_between(nodes.a, nodes.b, hertz_damp));
    nodes.start();
    commit_at(nodes, 0.1 + 1e-9, 0.0, speed, 0.0);
    const auto& block = nodes.model.block<LinkBlock<AnyContact>>();
    const ContactView contact = nodes.state->elements(0).contact(0);
    EXPECT_TRUE(contact.touching);
    EXPECT_EQ(contact.approach_speed, speed);
    const double mass = 750.0, duration = block.laws()[0].contact_duration(mass, 1e-4);
    EXPECT_DOUBLE_EQ(contact.expected_force, std::numbers::pi * mass * 1e-4 / duration);
    EXPECT_EQ(std::isnan(block.delivered_restitution(0, speed)), speed <= 0.0);
  }
}

template <class Law>
void expect_sound_gap(const Law& law) {
  TwoNodes nodes;
  add(nodes.model, gap_between(nodes.a, nodes.b, law));
  nodes.start();
  expect_exact_tangent(nodes, 0.05, 0.0, 0.5, 0.0, 1e-4);
  commit_at(nodes, 0.1 + 1e-9, 0.0, 0.5, 0.0);
  for (const double indentation : {1e-4, 0.01})
    for (const double rate : {0.4, -0.1})
      expect_exact_tangent(nodes, 0.1 + indentation, 0.0, rate, 0.0, 1e-3 * indentation);
  expect_action_is_reaction(nodes);
  expect_rollback(nodes, 0.11, 0.0, 0.2, 0.1);
}

TEST(Gap, HasExactTangentsAndRollsBackWithEveryFormOfContact) {
  expect_sound_gap(hertz_damp);
  expect_sound_gap(elastic);
  expect_sound_gap(Kelvin{.stiffness = 1e8 * N / m, .restitution = 0.65});
  expect_sound_gap(NonlinearViscoelastic{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65});
  expect_sound_gap(NamedImpactLaw{.name = "exact_hertz_damp", .hertz_stiffness = 1e9 * N / m_3_2, .restitution = 0.4});
}

TEST(Gap, NamesTheMistake) {
  TwoNodes nodes;
  Gap closed = gap_between(nodes.a, nodes.b, hertz_damp);
  closed.clearance = -10 * cm;
  EXPECT_EQ(message_of([&] { add(nodes.model, closed); }),
            "Gap \"gap\": clearance = -0.1 m is not allowed; it must be >= 0 m and finite. "
            "Give the free distance at rest, 0 m for wall to wall; a preload is an initial_displacement.");
  EXPECT_EQ(message_of([&] { add(nodes.model, gap_between(nodes.a, nodes.a, hertz_damp)); }),
            "Gap \"gap\": left and right are the same node, \"a\". An element joins two different nodes.");
  EXPECT_EQ(
      message_of([&] {
        add(nodes.model, gap_between(nodes.a, ground, HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 65.0}));
      }),
      "Gap \"gap\": restitution = 65 is not allowed; it must be > 0 and <= 1. It is the speed after the impact over "
      "the speed before; 1 is elastic.");
  EXPECT_EQ(nodes.model.blocks().size(), 0U) << "a refused gap left something behind";
  add(nodes.model, gap_between(nodes.a, ground, hertz_damp));
  EXPECT_EQ(message_of([&] { add(nodes.model, gap_between(ground, nodes.a, hertz_damp)); }),
            "Gap \"gap\": an element of this name exists. Give every element its own name.");
}

}  // namespace
}  // namespace moat::testing
