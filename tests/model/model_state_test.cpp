// The state of a model: committed or dropped, copied, and continued after something was added.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

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

Fingerprint fingerprint(const Model& original) {
  Model copy = original;
  const MotionState state = copy.state();
  const Vector forces = testing::forces_at(copy, Vector{{0.031, 0.033}}, Vector{{0.2, -0.1}});
  return {state.time, state.displacement, state.velocity, state.acceleration, forces};
}

TEST(ModelState, StartsFromInitialValues) {
  Model model;
  add(model, Node{.name = "a", .mass = 2 * kg, .initial_displacement = 3 * cm, .initial_velocity = -4 * m / s});
  add(model, Node{.name = "b", .mass = 5 * kg});
  model.prepare();
  EXPECT_EQ(model.state().time, 0.0);
  EXPECT_EQ(model.state().displacement, (Vector{{0.03, 0.0, 0.0}}));  // the last entry is the ground's
  EXPECT_EQ(model.state().velocity, (Vector{{-4.0, 0.0, 0.0}}));
  EXPECT_EQ(model.state().acceleration, Vector::Zero(3));
  EXPECT_EQ(model.masses(), (Vector{{2.0, 5.0}}));
  EXPECT_EQ(model.degrees_of_freedom(), 2);
}

TEST(ModelState, EvaluateWithoutCommitLeavesTheCommittedStateAlone) {
  Isolated made = isolated_storey();
  Model& model = made.model;
  Transient analysis{model, shaking(), fixed_step};
  for (int i = 0; i < 120; ++i) analysis.advance();
  const Fingerprint before = fingerprint(model);
  // Far beyond yield and into the wall, then out on the other side.
  for (const double displacement : {0.3, -0.3, 0.002})
    testing::move_to(model, Vector::Constant(2, displacement), Vector::Constant(2, -displacement));
  EXPECT_EQ(fingerprint(model), before);
  model.commit();
  EXPECT_NE(fingerprint(model), before);
}

TEST(ModelState, CommittedHistoryMatters) {
  // Loaded beyond yield and back: the bearing keeps a slip.
  Isolated made = isolated_storey();
  Model& model = made.model;
  model.prepare();
  for (const auto& [displacement, velocity] : {std::pair{0.03, 1.0}, {0.03, -1.0}, {0.0, -1.0}}) {
    testing::move_to(model, Vector::Constant(2, displacement), Vector::Constant(2, velocity));
    testing::commit_with_regimes(model);
  }
  const Vector& forces = model.internal_forces();
  // k1 = 4 MN/m, k2 = 0.4 MN/m, d_y = 1 cm: slip 2 cm, of which unloading by 3 cm takes 1 cm back.
  EXPECT_NEAR(forces[made.base.index], -(4e6 - 0.4e6) * 0.01, 1e-6);
}

TEST(ModelState, ACopyInTheMiddleContinuesBitForBitTheSame) {
  Isolated made = isolated_storey();
  Model& model = made.model;
  Transient analysis{model, shaking(), fixed_step};
  int steps_until_contact = 0;
  // Copy while the base leans on the wall: the approach speed of the touch is history too.
  while (std::abs(model.state().displacement[made.base.index]) < 0.041 && !analysis.finished()) {
    analysis.advance();
    ++steps_until_contact;
  }
  ASSERT_FALSE(analysis.finished());
  ASSERT_GT(steps_until_contact, 10);

  Model copy = model;
  EXPECT_EQ(fingerprint(copy), fingerprint(model));
  Transient of_original{model, shaking(), fixed_step};
  Transient of_copy{copy, shaking(), fixed_step};
  while (!of_original.finished()) {
    of_original.advance();
    of_copy.advance();
    ASSERT_EQ(fingerprint(copy), fingerprint(model)) << "t = " << model.state().time << " s";
  }
  EXPECT_TRUE(of_copy.finished());
}

TEST(ModelState, CopiesEvolveIndependently) {
  Isolated made = isolated_storey();
  Transient analysis{made.model, shaking(), fixed_step};
  for (int i = 0; i < 100; ++i) analysis.advance();
  const Fingerprint before = fingerprint(made.model);
  Model copy = made.model;
  Transient of_copy{copy, shaking(), fixed_step};
  for (int i = 0; i < 300; ++i) of_copy.advance();
  EXPECT_EQ(fingerprint(made.model), before);
  EXPECT_NE(fingerprint(copy), before);

  // Assignment replaces everything; a copy outlives its original.
  Model assigned;
  {
    const Model temporary = made.model;
    assigned = temporary;
  }
  EXPECT_EQ(fingerprint(assigned), before);
  const Model moved = std::move(assigned);
  EXPECT_EQ(fingerprint(moved), before);
}

TEST(ModelState, WhatIsAddedToACopyIsNotInTheOriginal) {
  Isolated made = isolated_storey();
  Model copy = made.model;
  const NodeId annex = add(copy, Node{.name = "annex", .mass = 1 * tonne});
  add(copy, ShearSpring{.name = "bridge", .lower = made.base, .upper = annex, .stiffness = 1 * MN / m});
  copy.prepare();
  made.model.prepare();
  EXPECT_EQ(copy.degrees_of_freedom(), 3);
  EXPECT_EQ(made.model.degrees_of_freedom(), 2);
  EXPECT_THROW(static_cast<void>(made.model.node(annex)), InputError);
  EXPECT_EQ(made.model.blocks().front()->size(), 1u);
  EXPECT_EQ(copy.blocks().front()->size(), 2u);
}

TEST(ModelState, GoesOnFromWhereItIsWhenSomethingIsAdded) {
  Isolated made = isolated_storey();
  Model& model = made.model;
  {
    Transient analysis{model, shaking(), fixed_step};
    for (int i = 0; i < 100; ++i) analysis.advance();
  }
  const MotionState before = model.state();
  ASSERT_NE(before.displacement[0], 0.0);
  add(model, Node{.name = "annex", .mass = 1 * tonne, .initial_displacement = 2 * cm});
  model.prepare();
  EXPECT_EQ(model.state().time, before.time);
  EXPECT_EQ(model.state().displacement.head(2), before.displacement.head(2));
  EXPECT_EQ(model.state().velocity.head(2), before.velocity.head(2));
  EXPECT_EQ(model.state().displacement[2], 0.02);
  EXPECT_EQ(model.state().displacement[3], 0.0);
}

TEST(ModelState, TangentIsTheDerivativeOfTheForces) {
  Isolated made = isolated_storey();
  Model& model = made.model;
  Transient analysis{model, shaking(), fixed_step};
  while (std::abs(model.state().displacement[made.base.index]) < 0.041 && !analysis.finished()) analysis.advance();
  ASSERT_FALSE(analysis.finished());

  // A little deeper than the committed state, where the bearing stands at its corner.
  const Vector u = model.state().displacement.head(2) * 1.02, v = model.state().velocity.head(2);
  const testing::Derivatives slopes = testing::derivatives_at(model, u, v, 1e-7, 1e-5);
  const Eigen::Matrix2d stiffness = slopes.stiffness.topRows(2), damping = slopes.damping.topRows(2);
  testing::move_to(model, u, v);
  EXPECT_EQ(testing::tangent_of(model, 3.0, 0.0, 0.0), Eigen::MatrixXd{(3.0 * model.masses()).asDiagonal()});
  EXPECT_LT((testing::tangent_of(model, 0.0, 0.0, 2.0) - 2.0 * stiffness).norm(), 1e-5 * stiffness.norm());
  EXPECT_LT((testing::tangent_of(model, 0.0, 5.0, 0.0) - 5.0 * damping).norm(), 1e-5 * damping.norm());
}

TEST(ModelState, RefusesNodesThatHaveNone) {
  Model model;
  const NodeId node = add(model, Node{.name = "base", .mass = 1 * tonne});
  EXPECT_THROW(static_cast<void>(model.displacement(node)), InputError);  // not prepared
  EXPECT_THROW(static_cast<void>(model.displacement(ground)), InputError);
  model.prepare();
  EXPECT_EQ(model.displacement(node), 0.0);
  EXPECT_EQ(model.velocity(ground), 0.0);
  EXPECT_EQ(model.mass(node), 1e3);
  EXPECT_THROW(static_cast<void>(model.displacement(NodeId{7})), InputError);
  EXPECT_THROW(static_cast<void>(model.acceleration(NodeId{})), InputError);
  EXPECT_THROW(static_cast<void>(model.mass(ground)), InputError);
  const NodeId later = add(model, Node{.name = "later", .mass = 1 * tonne});
  EXPECT_THROW(static_cast<void>(model.velocity(later)), InputError);
  EXPECT_EQ(model.velocity(ground), 0.0);
}

// A message that names an element must not name its neighbour.
TEST(ModelState, AScanOfABlockKnowsTheNearestElement) {
  Model model = isolated_storey().model;
  model.prepare();
  for (const double displacement : {0.03, -0.03}) {
    testing::move_to(model, Vector{{displacement}}, {}, 0.01);
    for (const auto& block : model.blocks()) {
      if (block->contacts() == nullptr) continue;
      RegimeScan scan;
      block->regimes()->scan(0.01, -1e-13, scan);
      EXPECT_EQ(block->info(scan.nearest).name, displacement > 0.0 ? "right" : "left");
    }
  }
}

}  // namespace
}  // namespace moat
