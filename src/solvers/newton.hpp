// Newton-Raphson for one nonlinear system, solved again and again.
#pragma once

#include <memory>

#include "base/vector.hpp"

namespace moat {

/// Equations r(x) = 0 with a tangent the system factorises and solves itself.
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
  /// only after the first compute_direction() of a solve.
  [[nodiscard]] virtual double round_off(int /*row*/) const { return 0.0; }

  /// direction := -(dr/dx)^-1 residual at the x last given to compute_residual(). False if the tangent is singular.
  virtual bool compute_direction(const Vector& residual, Vector& direction) = 0;
};

/// When to stop.
struct NewtonOptions {
  /// Largest residual over its row's scale. 0 < tolerance < 1.
  double tolerance = 1e-10;
  /// 1 <= max_iterations.
  int max_iterations = 20;
};

/// How it ended.
struct NewtonReport {
  bool converged = false;           ///< within the tolerance
  int iterations = 0;               ///< >= 0
  double residual = 0.0;            ///< largest residual over its row's scale; NaN where it is not a number
  int worst_degree_of_freedom = 0;  ///< where it is
};

/// Full Newton steps by Trilinos NOX, by default at least one: where some rows balance already, others may not, and a
/// linear system is solved by the first step anyway. The solver object is made once for a size and reused: after the
/// first call solve() allocates nothing. One per thread.
class NewtonSolver {
 public:
  /// The system must outlive the solver.
  NewtonSolver(NonlinearSystem& system, NewtonOptions options);
  ~NewtonSolver();
  NewtonSolver(NewtonSolver&&) noexcept;
  NewtonSolver& operator=(NewtonSolver&&) noexcept;

  /// Starts from x and leaves the last iterate there; the last call to compute_residual() was at that x. An x that is
  /// already the result of a Newton step needs no other if it balances: `least_iterations` 0.
  NewtonReport solve(Vector& x, int least_iterations = 1);

 private:
  struct Nox;
  std::unique_ptr<Nox> nox_;
};

}  // namespace moat
