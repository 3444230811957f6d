// Sparse LU factorisation.
#pragma once

#include <memory>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// LU factors of a sparse matrix, symmetric or not. KLU (SuiteSparse) finds permutations and pattern at the first
/// matrix. Later matrices of the same pattern are factorised on it (solvers/lu_factors.hpp); where that leads to poor
/// pivots, KLU looks for others.
///
/// Move-only; one per thread.
class Factorisation {
 public:
  /// In AMD's order of elimination.
  Factorisation();
  /// These rows and columns, ascending, change more often than the others and are eliminated last, in CAMD's order:
  /// where no other changes, they are all that is factorised again.
  explicit Factorisation(std::vector<int> changing_columns);
  ~Factorisation();
  Factorisation(Factorisation&&) noexcept;
  Factorisation& operator=(Factorisation&&) noexcept;

  /// Factorises A, whose pattern must be that of the first call. False if A is singular or not finite.
  [[nodiscard]] bool factorise(const SparseMatrix& matrix);
  /// The same for a matrix that may differ from the last one in the changing rows and columns only.
  [[nodiscard]] bool factorise_changing(const SparseMatrix& matrix);

  /// x := A^-1 x.
  void solve(Vector& x) const;

  /// How often factors were computed.
  [[nodiscard]] long count() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace moat
