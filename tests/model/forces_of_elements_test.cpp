// Forces and tangents of all elements of a model.

#include <gtest/gtest.h>

#include <cmath>

#include "moat.hpp"
#include "moved_model.hpp"

namespace moat {
namespace {

using namespace units;

// Two isolated buildings of two nodes that pound each other, and a node on a damper to the ground.
Model pounding_buildings() {
  Model model;
  NodeId bases[2];
  for (const int i : {0, 1}) {
    const std::string number = std::to_string(i + 1);
    const NodeId base = bases[i] = add(model, Node{.name = "base " + number, .mass = (50.0 + i) * tonne});
    const NodeId floor = add(model, Node{.name = "floor " + number, .mass = 40 * tonne});
    add(model, ShearSpring{.name = "storey " + number, .lower = base, .upper = floor, .stiffness = 80 * MN / m});
    add(model, ViscousDamper{.name = "damper " + number, .lower = base, .upper = floor, .damping = 90 * kN * s / m});
    add(model, LeadRubberBearing{.name = "bearing " + number,
                                 .upper = base,
                                 .yield_force = 40 * kN,
                                 .yield_displacement = 1 * cm,
                                 .post_yield_stiffness = 400 * kN / m});
  }
  const NodeId alone = add(model, Node{.name = "alone", .mass = 1 * tonne});
  add(model, ViscousDamper{.name = "damper", .lower = ground, .upper = alone, .damping = 9 * kN * s / m});
  add(model, Gap<HertzDamp>{.name = "gap",
                            .left = bases[0],
                            .right = bases[1],
                            .clearance = 1 * cm,
                            .law = HertzDamp{.stiffness = 3e8 * N / m_3_2, .restitution = 0.65}});
  return model;
}

void move(AnalysisState& state, int round) {
  MotionState& trial = state.trial();
  for (int i = 0; i < state.model().degrees_of_freedom(); ++i) {
    trial.displacement[i] = 0.03 * std::sin(1.0 + 2.3 * i + round);
    trial.velocity[i] = 0.5 * std::cos(2.0 + 1.7 * i + round);
  }
}

// Rates of forces are those of the forces, whose differences over a short time are exact for linear elements. The
// jerk is the rate of the force over the mass.
TEST(ForcesOfElements, HaveTheirRates) {
  const Model model = pounding_buildings();
  AnalysisState state{model};
  constexpr double time = 1e-3;
  const int count = model.degrees_of_freedom();
  move(state, 1);
  MotionState& trial = state.trial();
  for (int i = 0; i < count; ++i) trial.acceleration[i] = std::sin(0.3 + i);
  state.evaluate();
  state.evaluate_rates();
  const Vector before = state.internal_forces().head(count),
               rates = -model.mass_matrix().diagonal().cwiseProduct(trial.jerk.head(count));
  trial.displacement += time * trial.velocity;
  trial.velocity += time * trial.acceleration;
  state.evaluate();
  const Vector after = state.internal_forces().head(count);
  // The floors and the node alone: linear elements, and no gap.
  for (const int i : {1, 3, 4}) EXPECT_NEAR((after - before)[i] / time, rates[i], 1e-9 * rates.norm()) << i;
}

// Nodes that move together far from the ground, joined by links of 1e12 N/m: products of a stiffness matrix with
// displacements in place of their differences would have an error of 1e-4 N.
TEST(ForcesOfElements, OfStiffLinksBetweenNodesThatMoveTogetherHaveNoRoundOff) {
  Model model;
  NodeId before = add(model, Node{.name = "node 0", .mass = 1 * tonne});
  constexpr int links = 40;
  constexpr double stiffness = 1e12;
  for (int i = 1; i <= links; ++i) {
    const std::string number = std::to_string(i);
    const NodeId next = add(model, Node{.name = "node " + number, .mass = 1 * tonne});
    add(model, ShearSpring{.name = "link " + number, .lower = before, .upper = next, .stiffness = stiffness * N / m});
    before = next;
  }
  AnalysisState state{model};
  Vector u(links + 1);
  for (int i = 0; i <= links; ++i) u[i] = 0.3 + 1e-9 * std::sin(1.0 + 2.3 * i);
  const Vector forces = testing::forces_at(state, u);
  for (int i = 1; i < links; ++i)
    EXPECT_NEAR(forces[i], stiffness * ((u[i] - u[i - 1]) - (u[i + 1] - u[i])), 1e-11) << i;
  EXPECT_GT(forces.lpNorm<Eigen::Infinity>(), 1e3);
}

// Forces follow from the tangents and the forces at rest, with elastic and with sliding bearings, and an open gap.
TEST(ForcesOfElements, FollowFromTheLinearisedModel) {
  const Model model = pounding_buildings();
  AnalysisState state{model};
  const int count = model.degrees_of_freedom();
  SparseMatrix stiffness = model.zero_matrix(), damping = stiffness;
  Vector at_rest;
  for (const double displacement : {0.005, 0.02}) {
    testing::move_to(state, Vector::Constant(count, displacement), Vector::Constant(count, 0.1));
    EXPECT_EQ(testing::commit_with_regimes(state).size(), displacement > 0.01 ? 2u : 0u);
    state.linearise(stiffness, damping, at_rest);
    Vector u(count), v(count);
    for (int i = 0; i < count; ++i) {
      u[i] = 0.03 + 0.001 * i;  // the gap stays open
      v[i] = 0.5 * std::cos(2.0 + 1.7 * i);
    }
    const Vector expected = testing::forces_at(state, u, v).head(count);
    const Vector found = at_rest.head(count) + stiffness * u + damping * v;
    EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm());
  }
}

}  // namespace
}  // namespace moat
