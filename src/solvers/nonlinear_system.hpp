// The interface of equations that Newton-Raphson solves.
#pragma once

#include "base/vector.hpp"

namespace moat {

/// Equations r(x) = 0 with the Jacobian dr/dx, which the system factorises and solves itself.
class NonlinearSystem {
 public:
  virtual ~NonlinearSystem() = default;

  /// Number of unknowns.
  [[nodiscard]] virtual int size() const = 0;

  /// residual := r(x). False if x is outside the domain of the equations.
  virtual bool compute_residual(const Vector& x, Vector& residual) = 0;

  /// The sizes > 0 that the residuals are judged against, row by row, of the x last given to compute_residual().
  [[nodiscard]] virtual const Vector& residual_scales() const = 0;

  /// A residual of this row up to this, in its unit, is round-off of the x last given to compute_residual(). Called
  /// only after the first compute_jacobian() of a solve.
  [[nodiscard]] virtual double round_off(int /*row*/) const { return 0.0; }

  /// Factorises dr/dx at the x last given to compute_residual(). False if it is singular.
  virtual bool compute_jacobian() = 0;

  /// vector := (dr/dx)^-1 vector, with the factors of the last compute_jacobian().
  virtual void solve(Vector& vector) const = 0;
};

}  // namespace moat
