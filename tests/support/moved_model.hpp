// Models that tests move by hand: here alone tests set, evaluate and commit the motion of a model.
#pragma once

#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// Evaluates the model at these displacements and velocities of its first degrees of freedom, m and m/s, so many
/// seconds after the committed state. All others keep the motion of that state.
inline void move_to(Model& model, const Vector& displacements, const Vector& velocities = {}, double passed = 0.0) {
  MotionState& trial = model.trial();
  trial = model.state();
  trial.time += passed;
  trial.displacement.head(displacements.size()) = displacements;
  trial.velocity.head(velocities.size()) = velocities;
  model.evaluate();
}

/// The forces of all elements on the nodes and, in the last row, on the ground, at this motion.
inline Vector forces_at(Model& model, const Vector& displacements, const Vector& velocities = {}, double passed = 0.0) {
  move_to(model, displacements, velocities, passed);
  return model.internal_forces();
}

/// Commits the motion that was evaluated last and changes the regimes that end there. Returns the changes.
inline std::vector<RegimeChange> commit_with_regimes(Model& model) {
  model.commit();
  std::vector<RegimeChange> changes;
  model.change_regimes(changes);
  return changes;
}

/// mass M + damping C + stiffness K of the motion that was evaluated last.
inline Eigen::MatrixXd tangent_of(const Model& model, double mass, double damping, double stiffness) {
  SparseMatrix tangent = model.zero_matrix();
  model.assemble_tangent(mass, damping, stiffness, tangent);
  return Eigen::MatrixXd{tangent};
}

/// The derivatives of forces_at() by displacements and by velocities, from differences of these widths.
struct Derivatives {
  Eigen::MatrixXd stiffness, damping;
};
inline Derivatives derivatives_at(Model& model, const Vector& displacements, const Vector& velocities, double width,
                                  double velocity_width, double passed = 0.0) {
  const Eigen::Index count = displacements.size();
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(model.degrees_of_freedom() + 1, count);
  Derivatives found{zero, zero};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector by = width * Vector::Unit(count, i), faster = velocity_width * Vector::Unit(count, i);
    found.stiffness.col(i) = (forces_at(model, displacements + by, velocities, passed) -
                              forces_at(model, displacements - by, velocities, passed)) /
                             (2.0 * width);
    found.damping.col(i) = (forces_at(model, displacements, velocities + faster, passed) -
                            forces_at(model, displacements, velocities - faster, passed)) /
                           (2.0 * velocity_width);
  }
  return found;
}

}  // namespace moat::testing
