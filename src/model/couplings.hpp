// The pattern of a model's matrices, and places in it.
#pragma once

#include <vector>

#include "base/sparse_matrix.hpp"

namespace moat {

/// Index of the ground among degrees of freedom: a row and column that are not solved for.
inline constexpr int ground_index = -1;

/// The position of entry (row, column) among the values of a compressed matrix; -1 where either is the ground. Throws
/// std::out_of_range for an entry that the matrix does not have.
[[nodiscard]] int entry_position(const SparseMatrix& matrix, int row, int column);

/// Adds to the value at a position from entry_position(); nothing for the ground's.
inline void add_to_entry(double* values, int position, double value) {
  if (position >= 0) values[position] += value;
}

/// Collects which degrees of freedom couple.
class Couplings {
 public:
  /// Size >= 0 degrees of freedom.
  explicit Couplings(int size);

  /// Entries (a, b) and (b, a); the ground is ignored.
  void couple(int a, int b);
  /// Zero at all entries of couplings and on the whole diagonal.
  [[nodiscard]] SparseMatrix zero_matrix() const;

 private:
  int size_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace moat
