// Triangular factors of a sparse matrix whose pattern is known.
#pragma once

#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// Factors L U = P A Q of a sparse matrix A: L has ones on its diagonal, P and Q are permutations. Their pattern is
/// found by a full factorisation, such as KLU's; values are computed again on that pattern, from the first column that
/// changed. Column k of both factors depends on the first k columns of A Q alone.
///
/// Where only the last rows and columns change from matrix to matrix, the share of the others in them is computed once
/// and kept: A is condensed to these rows and columns,
///
///     | A11 A12 |       A22 - A21 A11^-1 A12 = L22 U22
///     | A21 A22 |
class LuFactors {
 public:
  /// Compressed columns, with ascending rows in each.
  struct Columns {
    std::vector<int> starts, rows;  ///< `starts` has one entry more than there are columns
    std::vector<double> values{};   ///< as long as `rows`
  };

  /// No factors.
  LuFactors() = default;
  /// The pattern of L below and of U above their diagonals, the row of A that is row k of P A, the column of A that is
  /// column k of A Q, and the size of A11, 0 where any row or column may change. Values are those of
  /// refactorise(), and may be left out here.
  LuFactors(Columns lower, Columns upper, std::vector<int> rows, std::vector<int> columns, int condensed);

  /// Whether there are none.
  [[nodiscard]] bool empty() const { return columns_.empty(); }
  /// The k of a column of A in A Q.
  [[nodiscard]] int position(int column) const { return positions_[static_cast<std::size_t>(column)]; }
  /// The column of A that is column k of A Q.
  [[nodiscard]] int column(int k) const { return columns_[static_cast<std::size_t>(k)]; }

  /// Factorises a matrix that differs from the last one in columns `first` of A Q and later ones only, and if these
  /// belong to A22, in no row of A12. False if a pivot is zero, not finite, or smaller than the largest one by 1e13:
  /// then other permutations are needed.
  [[nodiscard]] bool refactorise(const SparseMatrix& matrix, int first);
  /// x := A^-1 x.
  void solve(Vector& x) const;

 private:
  [[nodiscard]] bool has_good_pivots() const;

  Columns lower_, upper_;
  std::vector<int> rows_, columns_;                 // of A, in order of elimination
  std::vector<int> positions_, positions_of_rows_;  // the inverse permutations
  int condensed_ = 0;                               // size of A11
  std::vector<int> upper_splits_;                   // of every column of U22, where its rows begin
  Columns share_;                                   // -A21 A11^-1 A12, on the pattern of L22 + U22
  Vector inverse_pivots_;
  mutable Vector work_;  // zero between calls of refactorise()
};

}  // namespace moat
