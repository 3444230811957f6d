// Triangular factors of a sparse matrix whose pattern is known.
#pragma once

#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// Factors L U = P A Q of a sparse matrix A: L has ones on its diagonal, P and Q are permutations. Their pattern is
/// found by a full factorisation, such as KLU's; values are computed again on that pattern, column by column.
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
  /// column k of A Q, the pattern of A, and the size of A11, 0 where any row or column may change. Values are those of
  /// refactorise(), and may be left out here.
  LuFactors(Columns lower, Columns upper, std::vector<int> rows, std::vector<int> columns,
            const SparsityPattern& pattern, int condensed);

  /// Whether there are none.
  [[nodiscard]] bool empty() const { return columns_.empty(); }

  /// Factorises a matrix of that pattern. False if a pivot is zero, not finite, or smaller than the largest one by
  /// 1e13: then other permutations are needed.
  [[nodiscard]] bool refactorise(const SparseMatrix& matrix);
  /// The same for a matrix that differs from the last one in A22 only.
  [[nodiscard]] bool refactorise_condensed(const SparseMatrix& matrix);
  /// x := A^-1 x.
  void solve(Vector& x) const;

 private:
  template <class TakeColumn>
  void eliminate(int first, const TakeColumn& take_column);
  void compute_share();
  [[nodiscard]] bool has_good_pivots() const;

  Columns lower_, upper_;
  std::vector<int> rows_, columns_;  // of A, in order of elimination
  std::vector<int> entry_rows_;      // the row in P A of every entry of A
  int condensed_ = 0;                // size of A11
  std::vector<int> upper_splits_;    // of every column of U22, where its rows begin
  Columns share_;                    // -A21 A11^-1 A12, on the pattern of L22 + U22
  bool has_share_ = false;           // of the present A11, A12 and A21
  Vector inverse_pivots_;
  mutable Vector work_;  // zero between calls
};

}  // namespace moat
