// Newton-Raphson for one nonlinear system, solved again and again.
#pragma once

#include <memory>

#include "base/vector.hpp"
#include "solvers/nonlinear_system.hpp"

namespace moat {

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
