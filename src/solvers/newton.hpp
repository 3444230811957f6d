// Newton-Raphson for one nonlinear system, solved again and again.
#pragma once

#include <memory>

#include "base/state_archive.hpp"
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

/// How far along the Newton direction an iteration goes: a line search of NOX.
enum class LineSearch {
  full_step,  ///< the whole way; a solve that fails so is tried once more with `backtrack`
  backtrack   ///< half, a quarter ... of the way, until the worst row has a smaller residual over its scale
};

/// When to stop, and how far to go.
struct NewtonOptions {
  /// Largest residual over its row's scale. 0 < tolerance < 1.
  double tolerance = 1e-10;
  /// 1 <= max_iterations.
  int max_iterations = 20;
  /// Full steps are the cheapest, and nearly always converge.
  LineSearch line_search = LineSearch::full_step;
};

/// How it ended.
struct NewtonReport {
  bool converged = false;           ///< within the tolerance
  int iterations = 0;               ///< of NOX, with those of a first attempt; >= 0
  double residual = 0.0;            ///< largest residual over its row's scale; NaN where it is not a number
  int worst_degree_of_freedom = 0;  ///< where it is
};

/// Newton's method by Trilinos NOX: its line-search solver iterates, its line search sets the length of each step, and
/// its status tests stop it, among them one of our own (ForceBalance). At least one iteration is made: where some rows
/// balance already, others may not, and a linear system is solved by the first one anyway. NOX's solvers are made once
/// for a size and reused: after the first call solve() allocates nothing. One per thread.
class NewtonSolver {
 public:
  /// The system must outlive the solver. Throws InputError for options out of range.
  NewtonSolver(NonlinearSystem& system, NewtonOptions options);
  ~NewtonSolver();
  NewtonSolver(NewtonSolver&&) noexcept;
  NewtonSolver& operator=(NewtonSolver&&) noexcept;

  /// Writes or reads the scale by which round-off is judged, all that one solve() leaves for the next.
  void archive(StateArchive& archive);
  /// Starts from x and leaves the last iterate there; the last call to compute_residual() was at that x.
  NewtonReport solve(Vector& x);

 private:
  struct Nox;
  std::unique_ptr<Nox> nox_;
};

}  // namespace moat
