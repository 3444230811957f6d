// The state of a model in an analysis: committed or dropped, copied, and of the model that it was made for.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "moat.hpp"
#include "moved_model.hpp"

namespace moat {
namespace {

using namespace units;

struct Isolated {
  Model model;
  NodeId base, floor;
};

// One storey on a bearing between walls: something of every kind of history.
Isolated isolated_storey() {
  Isolated made;
  Model& model = made.model;
  made.base = add(model, Node{.name = "base", .mass = 50 * tonne});
  made.floor = add(model, Node{.name = "floor", .mass = 40 * tonne});
  add(model, ShearSpring{.name = "storey", .lower = made.base, .upper = made.floor, .stiffness = 80 * MN / m});
  add(model, ViscousDamper{.name = "damper", .lower = made.base, .upper = made.floor, .damping = 90 * kN * s / m});
  add(model, LeadRubberBearing{.upper = made.base,
                               .yield_force = 40 * kN,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = 400 * kN / m});
  const HertzDamp law{.stiffness = 3e8 * N / m_3_2, .restitution = 0.65};
  add(model, Gap<HertzDamp>{.name = "left", .left = ground, .right = made.base, .clearance = 4 * cm, .law = law});
  add(model, Gap<HertzDamp>{.name = "right", .left = made.base, .right = ground, .clearance = 4 * cm, .law = law});
  return made;
}

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i <= 400; ++i) samples.push_back(4.0 * std::sin(0.05 * i) * std::sin(0.013 * i));
  return GroundMotion{"synthetic shaking", 0.01, std::move(samples)};
}

const TransientOptions fixed_step{.step = 5 * ms};

// All data that later steps depend on: the motion, and the forces of the elements at one and the same trial motion.
struct Fingerprint {
  double time;
  Vector displacement, velocity, acceleration, forces;
  bool operator==(const Fingerprint&) const = default;
};

Fingerprint fingerprint(const AnalysisState& original) {
  AnalysisState copy = original;
  const MotionState motion = copy.motion();
  const Vector forces = testing::forces_at(copy, Vector{{0.031, 0.033}}, Vector{{0.2, -0.1}});
  return {motion.time, motion.displacement, motion.velocity, motion.acceleration, forces};
}

// Until the base leans on a wall.
void advance_into_contact(Transient& analysis, NodeId base) {
  while (std::abs(analysis.state().displacement(base)) < 0.041 && !analysis.finished()) analysis.advance();
  ASSERT_FALSE(analysis.finished());
}

TEST(AnalysisState, StartsFromInitialValues) {
  Model model;
  add(model, Node{.name = "a", .mass = 2 * kg, .initial_displacement = 3 * cm, .initial_velocity = -4 * m / s});
  add(model, Node{.name = "b", .mass = 5 * kg});
  const AnalysisState state{model};
  EXPECT_EQ(state.time(), 0.0);
  EXPECT_EQ(state.motion().displacement, (Vector{{0.03, 0.0, 0.0}}));  // the last entry is the ground's
  EXPECT_EQ(state.motion().velocity, (Vector{{-4.0, 0.0, 0.0}}));
  EXPECT_EQ(state.motion().acceleration, Vector::Zero(3));
  EXPECT_EQ(model.mass_matrix().diagonal(), (Vector{{2.0, 5.0}}));
  EXPECT_EQ(model.degrees_of_freedom(), 2);
}

TEST(AnalysisState, EvaluateWithoutCommitLeavesTheCommittedStateAlone) {
  const Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  for (int i = 0; i < 120; ++i) analysis.advance();
  AnalysisState state = analysis.state();
  const Fingerprint before = fingerprint(state);
  // Far beyond yield and into the wall, then out on the other side.
  for (const double displacement : {0.3, -0.3, 0.002})
    testing::move_to(state, Vector::Constant(2, displacement), Vector::Constant(2, -displacement));
  EXPECT_EQ(fingerprint(state), before);
  state.commit();
  EXPECT_NE(fingerprint(state), before);
}

TEST(AnalysisState, CommittedHistoryMatters) {
  // Loaded beyond yield and back: the bearing keeps a slip.
  const Isolated made = isolated_storey();
  AnalysisState state{made.model};
  for (const auto& [displacement, velocity] : {std::pair{0.03, 1.0}, {0.03, -1.0}, {0.0, -1.0}}) {
    testing::move_to(state, Vector::Constant(2, displacement), Vector::Constant(2, velocity));
    testing::commit_with_regimes(state);
  }
  const Vector& forces = state.internal_forces();
  // k1 = 4 MN/m, k2 = 0.4 MN/m, d_y = 1 cm: slip 2 cm, of which unloading by 3 cm takes 1 cm back.
  EXPECT_NEAR(forces[made.base.index], -(4e6 - 0.4e6) * 0.01, 1e-6);
}

TEST(AnalysisState, ACopyInTheMiddleContinuesBitForBitTheSame) {
  const Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  // Copy while the base leans on the wall: the approach speed of the touch is history too.
  advance_into_contact(analysis, made.base);
  ASSERT_GT(analysis.statistics().accepted_steps, 10);

  const AnalysisState middle = analysis.state();
  EXPECT_EQ(fingerprint(middle), fingerprint(analysis.state()));
  Transient one{made.model, shaking(), middle, fixed_step}, other{made.model, shaking(), middle, fixed_step};
  while (!one.finished()) {
    one.advance();
    other.advance();
    ASSERT_EQ(fingerprint(other.state()), fingerprint(one.state())) << "t = " << one.state().time() << " s";
  }
  EXPECT_TRUE(other.finished());
}

TEST(AnalysisState, CopiesEvolveIndependently) {
  const Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  for (int i = 0; i < 100; ++i) analysis.advance();
  const Fingerprint before = fingerprint(analysis.state());
  Transient going_on{made.model, shaking(), analysis.state(), fixed_step};
  for (int i = 0; i < 300; ++i) going_on.advance();
  EXPECT_EQ(fingerprint(analysis.state()), before);
  EXPECT_NE(fingerprint(going_on.state()), before);

  // Assignment replaces everything; a copy outlives its original.
  AnalysisState assigned{made.model};
  {
    const AnalysisState temporary = analysis.state();
    assigned = temporary;
  }
  EXPECT_EQ(fingerprint(assigned), before);
  const AnalysisState moved = std::move(assigned);
  EXPECT_EQ(fingerprint(moved), before);
}

TEST(AnalysisState, WhatIsAddedToACopyOfTheModelIsNotInTheOriginal) {
  const Isolated made = isolated_storey();
  Model copy = made.model;
  const NodeId annex = add(copy, Node{.name = "annex", .mass = 1 * tonne});
  add(copy, ShearSpring{.name = "bridge", .lower = made.base, .upper = annex, .stiffness = 1 * MN / m});
  EXPECT_EQ(AnalysisState{copy}.motion().displacement.size(), 4);
  EXPECT_EQ(AnalysisState{made.model}.motion().displacement.size(), 3);
  EXPECT_THROW(static_cast<void>(made.model.body(annex)), InputError);
  EXPECT_EQ(made.model.blocks().front()->size(), 1u);
  EXPECT_EQ(copy.blocks().front()->size(), 2u);
}

TEST(AnalysisState, DoesNotFitAModelThatWasAddedTo) {
  Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  EnergyLedger ledger;
  analysis.attach(ledger);
  analysis.advance();
  EXPECT_TRUE(analysis.state().fits_model());
  add(made.model, ViscousDamper{.name = "later", .lower = ground, .upper = made.base, .damping = 1 * kN * s / m});
  EXPECT_FALSE(analysis.state().fits_model());
  EXPECT_NE(testing::message_of([&] { analysis.advance(); }).find("the model was added to"), std::string::npos);
  analysis.finish();
  EXPECT_EQ(ledger.at_end().input, 0.0) << "the ledger would walk over elements without a state";
  const std::string refusal =
      "Transient \"synthetic shaking\": the state is that of another model, or of this one before something was added "
      "to it. Give a state that an analysis of this model reached, or none.";
  EXPECT_EQ(testing::message_of([&] { Transient(made.model, shaking(), analysis.state(), fixed_step); }), refusal);
  const Model copy = made.model;
  EXPECT_EQ(testing::message_of([&] { Transient(copy, shaking(), AnalysisState{made.model}, fixed_step); }), refusal);
}

TEST(AnalysisState, TangentIsTheDerivativeOfTheForces) {
  const Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  advance_into_contact(analysis, made.base);

  // A little deeper than the committed state, where the bearing stands at its corner.
  AnalysisState state = analysis.state();
  const Vector u = state.motion().displacement.head(2) * 1.02, v = state.motion().velocity.head(2);
  const testing::Derivatives slopes = testing::derivatives_at(state, u, v, 1e-7, 1e-5);
  const Eigen::Matrix2d stiffness = slopes.stiffness.topRows(2), damping = slopes.damping.topRows(2);
  testing::move_to(state, u, v);
  EXPECT_EQ(testing::tangent_of(state, 3.0, 0.0, 0.0),
            Eigen::MatrixXd{(3.0 * made.model.mass_matrix().diagonal()).asDiagonal()});
  EXPECT_LT((testing::tangent_of(state, 0.0, 0.0, 2.0) - 2.0 * stiffness).norm(), 1e-5 * stiffness.norm());
  EXPECT_LT((testing::tangent_of(state, 0.0, 5.0, 0.0) - 5.0 * damping).norm(), 1e-5 * damping.norm());
}

TEST(AnalysisState, RefusesNodesThatHaveNone) {
  Model model;
  const NodeId node = add(model, Node{.name = "base", .mass = 1 * tonne});
  const AnalysisState state{model};
  EXPECT_EQ(state.displacement(node), 0.0);
  EXPECT_EQ(state.velocity(ground), 0.0);
  EXPECT_EQ(model.mass(node), 1e3);
  EXPECT_THROW(static_cast<void>(state.displacement(NodeId{7})), InputError);
  EXPECT_THROW(static_cast<void>(state.acceleration(NodeId{})), InputError);
  EXPECT_THROW(static_cast<void>(model.mass(ground)), InputError);
  const NodeId later = add(model, Node{.name = "later", .mass = 1 * tonne});
  EXPECT_THROW(static_cast<void>(state.velocity(later)), InputError);
  EXPECT_EQ(state.velocity(ground), 0.0);
}

}  // namespace
}  // namespace moat
