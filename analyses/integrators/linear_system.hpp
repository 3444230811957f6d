// A linear system under a ground acceleration that is linear in time.
#pragma once

#include <Eigen/Core>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/mass_matrix.hpp"

namespace moat {

/// The motion of
///
///     u'' = -M^-1 (K u + C u') + c,   c' = d iota
///
/// as z' = A z. With time counted in steps of length h, z = (u, h u', h^2 c, h^3 d) and
///
///         | 0            I           0  0    |
///     A = | -h^2 M^-1 K  -h M^-1 C   I  0    |
///         | 0            0           0  iota |
///         | 0            0           0  0    |
///
/// Velocities are scaled by h so that exp(A), by which z is multiplied over a step, is exact to round-off.
class LinearSystem {
 public:
  /// The series of LinearPath has the digits of the exponential up to here, and the cubic through the ends of a
  /// vibration misses it by 1.6e-4 of its amplitude.
  static constexpr double longest_phase = 0.5;

  /// Tangents of a model with its masses, and the displacements iota of its degrees of freedom with the ground. The
  /// step is the longest, in s, halved until the fastest eigenvalue times the step is at most the phase and
  /// `longest_phase`. Throws InputError where the latter needs more than 12 halvings.
  LinearSystem(const SparseMatrix& stiffness, const SparseMatrix& damping, const MassMatrix& mass,
               const Vector& influence, double longest_step, double wanted_phase = longest_phase);

  /// Whether it was made of these tangents.
  [[nodiscard]] bool is_of(const SparseMatrix& stiffness, const SparseMatrix& damping) const {
    return (stiffness_.coeffs() == stiffness.coeffs()).all() && (damping_.coeffs() == damping.coeffs()).all();
  }
  /// Returns h, s.
  [[nodiscard]] double step() const { return step_; }
  /// Returns A.
  [[nodiscard]] const Eigen::MatrixXd& rates() const { return rates_; }
  /// The rows of exp(A) that belong to u and h u'.
  [[nodiscard]] const Eigen::MatrixXd& over_step() const { return over_step_; }

 private:
  SparseMatrix stiffness_, damping_;
  double step_;
  Eigen::MatrixXd rates_, over_step_;
};

}  // namespace moat
