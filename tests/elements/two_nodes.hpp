// A model with two nodes and the ground, moved by hand.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "base/units.hpp"
#include "model/analysis_state.hpp"
#include "moved_model.hpp"

namespace moat::testing {

/// Nodes "a" (1 t) and "b" (3 t). add() elements to `model`, then start() and move(); `state` exists from start() on.
struct TwoNodes {
  Model model;
  NodeId a = add(model, Node{.name = "a", .mass = 1 * units::tonne});
  NodeId b = add(model, Node{.name = "b", .mass = 3 * units::tonne});

  std::optional<AnalysisState> state{};

  void start() { state.emplace(model); }

  /// The trial state, evaluated: displacements (m) and velocities (m/s) of both nodes.
  void move(double ua, double ub, double va = 0.0, double vb = 0.0) {
    move_to(*state, Vector{{ua, ub}}, Vector{{va, vb}});
  }

  /// Internal forces on a, b and the ground, N.
  [[nodiscard]] Eigen::Vector3d forces() const { return state->internal_forces(); }
};

/// The sum over nodes and ground is zero: the forces on the two ends are opposite.
inline void expect_action_is_reaction(const TwoNodes& nodes) {
  const Eigen::Vector3d force = nodes.forces();
  EXPECT_NEAR(force.sum(), 0.0, 1e-12 * force.cwiseAbs().maxCoeff());
}

/// The assembled tangent at a state against differences of the assembled forces; `width` in m and m/s is small
/// against the distance to the next change of branch.
inline void expect_exact_tangent(TwoNodes& nodes, double ua, double ub, double va, double vb, double width) {
  constexpr double displacement_weight = 0.7, velocity_weight = 0.3;
  const Derivatives slopes = derivatives_at(*nodes.state, Vector{{ua, ub}}, Vector{{va, vb}}, width, width);
  nodes.move(ua, ub, va, vb);
  const Eigen::MatrixXd exact = tangent_of(*nodes.state, 0.0, velocity_weight, displacement_weight),
                        expected = displacement_weight * slopes.stiffness.topRows(2) +
                                   velocity_weight * slopes.damping.topRows(2);
  EXPECT_LE((exact - expected).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff());
}

/// Trial states that are not committed leave no trace: the force at a state is the same before and after wandering.
inline void expect_rollback(TwoNodes& nodes, double ua, double ub, double va, double vb) {
  nodes.move(ua, ub, va, vb);
  const Eigen::Vector3d before = nodes.forces();
  for (const double away : {-0.3, 0.2, 0.05, -0.01}) nodes.move(ua + away, ub - 2.0 * away, away, -away);
  nodes.move(ua, ub, va, vb);
  EXPECT_EQ(nodes.forces(), before);
}

}  // namespace moat::testing
