// Equations with a part of low rank.
#pragma once

#include <Eigen/LU>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace moat {

/// The part U S' of a tangent A + U S' that comes from forces which follow axial forces. A column of U is the change of
/// all forces for a moment of 1 N m about one axis of one building, and a row of S' is that moment for accelerations.
///
///     (A + U S')^-1 y = x - Z (1 + S' Z)^-1 S' x,   x = A^-1 y,   Z = A^-1 U      (Woodbury)
class WeightCoupling {
 public:
  /// One entry of a sparse row.
  struct Entry {
    int index;      ///< of a degree of freedom
    double weight;  ///< kg m
  };
  std::vector<Vector> columns;           ///< U
  std::vector<std::vector<Entry>> rows;  ///< S'

  /// Returns row k of S' times a vector.
  [[nodiscard]] double row_times(std::size_t k, const double* values) const {
    double sum = 0.0;
    for (const Entry& entry : rows[k]) sum += entry.weight * values[entry.index];
    return sum;
  }
  /// Forms Z, with as many rows as there are unknowns, and 1 + S' Z for the inverse of A that `solve` applies to a
  /// vector in place. Returns the determinant of the latter: the motion is unique where it is positive.
  template <class Solve>
  double prepare(Eigen::Index unknowns, const Solve& solve, double factor = 1.0) {
    const auto size = static_cast<Eigen::Index>(columns.size());
    inverse_columns_.resize(columns.size());
    Eigen::MatrixXd small = Eigen::MatrixXd::Identity(size, size);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      inverse_columns_[k] = factor * columns[k].head(unknowns);
      solve(inverse_columns_[k]);
      for (std::size_t j = 0; j < rows.size(); ++j)
        small(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) += row_times(j, inverse_columns_[k].data());
    }
    factors_.compute(small);
    return factors_.determinant();
  }
  /// x := x - Z (1 + S' Z)^-1 S' x.
  void correct(Vector& x) const {
    Vector moments{static_cast<Eigen::Index>(rows.size())};
    for (std::size_t k = 0; k < rows.size(); ++k) moments[static_cast<Eigen::Index>(k)] = row_times(k, x.data());
    moments = factors_.solve(moments);
    for (std::size_t k = 0; k < rows.size(); ++k)
      x.head(inverse_columns_[k].size()) -= moments[static_cast<Eigen::Index>(k)] * inverse_columns_[k];
  }

 private:
  std::vector<Vector> inverse_columns_;  // Z
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace moat
