// States that tests move by hand: here alone tests set, evaluate and commit the motion of a state.
#pragma once

#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// Evaluates the state at these displacements and velocities of its first degrees of freedom, m and m/s, so many
/// seconds after the committed state. All others keep the motion of that state.
inline void move_to(AnalysisState& state, const Vector& displacements, const Vector& velocities = {},
                    double passed = 0.0) {
  MotionState& trial = state.trial();
  trial = state.motion();
  trial.time += passed;
  trial.displacement.head(displacements.size()) = displacements;
  trial.velocity.head(velocities.size()) = velocities;
  state.evaluate();
}

/// The forces of all elements on the nodes and, in the last row, on the ground, at this motion.
inline Vector forces_at(AnalysisState& state, const Vector& displacements, const Vector& velocities = {},
                        double passed = 0.0) {
  move_to(state, displacements, velocities, passed);
  return state.internal_forces();
}

/// Commits the motion that was evaluated last and changes the regimes that end there. Returns the changes.
inline std::vector<RegimeChange> commit_with_regimes(AnalysisState& state) {
  state.commit();
  std::vector<RegimeChange> changes;
  state.change_regimes(changes);
  return changes;
}

/// mass M + damping C + stiffness K of the motion that was evaluated last.
inline Eigen::MatrixXd tangent_of(const AnalysisState& state, double mass, double damping, double stiffness) {
  SparseMatrix tangent = state.zero_matrix();
  state.assemble_tangent(mass, damping, stiffness, tangent);
  return Eigen::MatrixXd{tangent};
}

/// The derivatives of forces_at() by displacements and by velocities, from differences of these widths.
struct Derivatives {
  Eigen::MatrixXd stiffness, damping;
};
inline Derivatives derivatives_at(AnalysisState& state, const Vector& displacements, const Vector& velocities,
                                  double width, double velocity_width, double passed = 0.0) {
  const Eigen::Index count = displacements.size();
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(state.model().degrees_of_freedom() + 1, count);
  Derivatives found{zero, zero};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector by = width * Vector::Unit(count, i), faster = velocity_width * Vector::Unit(count, i);
    found.stiffness.col(i) = (forces_at(state, displacements + by, velocities, passed) -
                              forces_at(state, displacements - by, velocities, passed)) /
                             (2.0 * width);
    found.damping.col(i) = (forces_at(state, displacements, velocities + faster, passed) -
                            forces_at(state, displacements, velocities - faster, passed)) /
                           (2.0 * velocity_width);
  }
  return found;
}

}  // namespace moat::testing
