// Sparse LU factorisation.
#pragma once

#include <memory>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// LU factors of a sparse matrix, symmetric or not, by KLU (SuiteSparse).
///
/// The ordering is found once, at the first matrix; later matrices of the same pattern are only
/// refactorised. Move-only; one per thread.
class Factorisation {
 public:
  Factorisation();
  ~Factorisation();
  Factorisation(Factorisation&&) noexcept;
  Factorisation& operator=(Factorisation&&) noexcept;

  /// Factorises A, whose pattern must be that of the first call. A call with the same values as
  /// before keeps the factors. False if A is singular or not finite.
  [[nodiscard]] bool factorise(const SparseMatrix& matrix);

  /// x := A^-1 x.
  void solve(Vector& x) const;

  /// How often factors were computed, not reused.
  [[nodiscard]] long count() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace moat
