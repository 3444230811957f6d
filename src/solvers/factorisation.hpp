// Sparse LU factorisation by SuiteSparse's KLU.
#pragma once

#include <memory>

#include "base/sparse_matrix.hpp"
#include "base/state_archive.hpp"
#include "base/vector.hpp"

namespace moat {

/// LU factors of a sparse matrix, symmetric or not. KLU analyses the pattern once, at the first matrix. It factorises
/// later matrices with the pivots of an earlier one, which is several times faster, and looks for new pivots where that
/// would lose more than about six digits.
///
/// Move-only; one per thread.
class Factorisation {
 public:
  Factorisation();
  ~Factorisation();
  Factorisation(Factorisation&&) noexcept;
  Factorisation& operator=(Factorisation&&) noexcept;

  /// Factorises A, whose pattern must be that of the first call. False if A is singular or not finite. Throws
  /// std::logic_error for another pattern.
  [[nodiscard]] bool factorise(const SparseMatrix& matrix);

  /// x := A^-1 x. Throws std::logic_error without factors.
  void solve(Vector& x) const;
  /// X := A^-1 X, for several right sides at once.
  void solve(Eigen::MatrixXd& x) const;

  /// Writes the factors, or reads them into a factorisation without any. `last` is the matrix of the last factorise():
  /// the factors are computed again from it and from the last matrix that got new pivots, with the same digits.
  void archive(StateArchive& archive, const SparseMatrix& last);

  /// How often factors were computed, with old or with new pivots.
  [[nodiscard]] long count() const;
  /// How often of these KLU looked for new pivots; 1 where those of the first matrix always served.
  [[nodiscard]] long pivot_searches() const;

 private:
  struct Klu;
  std::unique_ptr<Klu> klu_;
};

}  // namespace moat
