// Whether the rows of a nonlinear system balance.
#pragma once

#include "base/vector.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// The row of an iterate that is farthest from its balance.
struct WorstRow {
  double residual = 0.0;      ///< over the scale of the row; NaN where one is not a number
  int degree_of_freedom = 0;  ///< where it is
};

/// Rows balance where each residual is small relative to the scale of its own row. A residual of round-off (of
/// displacements, for example) may also be negligible beside the scale of its row, or beside the largest of all rows in
/// any solution so far. Where a structure is released, rows far from there have no forces but such round-off for many
/// steps; behind the end of a motion that may hold for all rows.
class ForceBalance {
 public:
  /// Limit for residuals that pass as round-off. The estimate of round-off uses the tangent of the previous iterate,
  /// which may be far from the solution.
  static constexpr double loosest_by_round_off = 1e-6;

  /// tolerance: of a residual over its row's scale, > 0.
  explicit ForceBalance(double tolerance) : tolerance_{tolerance} {}

  /// Returns the worst row at the x last given to the system.
  [[nodiscard]] static WorstRow worst_row(const Vector& residual, const NonlinearSystem& system);
  /// The row that is no number, or the first if the residual could not be computed.
  [[nodiscard]] static WorstRow no_number(const Vector& residual);
  /// Writes or reads the largest scale.
  void archive(auto& archive) { archive(largest_); }
  /// Whether all rows balance, after the first compute_direction() of a solve.
  [[nodiscard]] bool holds(const WorstRow& worst, const Vector& residual, const NonlinearSystem& system);

 private:
  [[nodiscard]] bool is_round_off(const Vector& residual, const NonlinearSystem& system, double largest) const;

  double tolerance_;
  double largest_ = 0.0;  // scale in a solution so far
};

}  // namespace moat
