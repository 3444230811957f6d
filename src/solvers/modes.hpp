// Periods and mode shapes of a linear structure.
#pragma once

#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// A mode of undamped vibration.
struct Mode {
  double angular_frequency = 0.0;  ///< rad/s
  Vector shape;                    ///< scaled so that shape^T M shape = 1, M in kg

  [[nodiscard]] double period() const;  ///< s; infinite for a rigid-body mode
};

/// The `count` slowest modes of K shape = omega^2 M shape, slowest first.
///
/// stiffness: symmetric, positive semi-definite, N/m; mass: the diagonal of M, kg, all > 0.
/// Small structures are solved dense by Eigen, large ones by Spectra's shift-and-invert Lanczos.
/// A mass matrix that is not diagonal takes the dense solution.
/// Throws InputError if count is not from 1 to the size, Error if the iteration does not converge.
std::vector<Mode> slowest_modes(const SparseMatrix& stiffness, const Vector& mass, int count);
/// Finds them for a symmetric and positive definite matrix M, kg; throws as for masses of the diagonal.
std::vector<Mode> slowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, int count);

}  // namespace moat
