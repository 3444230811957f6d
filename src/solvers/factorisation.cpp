#include "solvers/factorisation.hpp"

#include <klu.h>

#include <cstring>
#include <stdexcept>
#include <utility>

namespace moat {

struct Factorisation::Factors {
  klu_common common{};
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
  std::vector<int> column_starts, row_indices;
  std::vector<double> values;  // of the factors in `numeric`
  long count = 0;

  Factors() {
    klu_defaults(&common);
    // A structure couples all its degrees of freedom: there are no blocks to find. Masses on the
    // diagonal keep rows of similar size, so scaling would only cost time.
    common.btf = 0;
    common.scale = -1;
  }
  ~Factors() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  bool analyse(const SparseMatrix& matrix) {
    column_starts = matrix.column_starts;
    row_indices = matrix.row_indices;
    values.assign(matrix.row_indices.size(), 0.0);
    symbolic = klu_analyze(matrix.size, column_starts.data(), row_indices.data(), &common);
    return symbolic != nullptr;
  }

  bool factorise_anew() {
    klu_free_numeric(&numeric, &common);
    numeric = klu_factor(column_starts.data(), row_indices.data(), values.data(), symbolic, &common);
    // KLU takes a pivot that is not a number for one that is not zero; its condition estimate does not.
    return numeric != nullptr && common.status == KLU_OK && klu_rcond(symbolic, numeric, &common) != 0 &&
           common.rcond > 0.0;
  }

  // Refactorisation keeps the pivots of the first matrix; they may be poor ones for this matrix.
  bool refactorise() {
    constexpr double poor_pivots = 1e-13;
    return klu_refactor(column_starts.data(), row_indices.data(), values.data(), symbolic, numeric, &common) != 0 &&
           common.status == KLU_OK && klu_rcond(symbolic, numeric, &common) != 0 && common.rcond > poor_pivots;
  }
};

Factorisation::Factorisation() : factors_{std::make_unique<Factors>()} {}
Factorisation::~Factorisation() = default;
Factorisation::Factorisation(Factorisation&&) noexcept = default;
Factorisation& Factorisation::operator=(Factorisation&&) noexcept = default;

bool Factorisation::factorise(const SparseMatrix& matrix) {
  Factors& f = *factors_;
  if (f.symbolic == nullptr && !f.analyse(matrix)) return false;
  if (f.row_indices.size() != matrix.row_indices.size())
    throw std::logic_error{"Factorisation: the pattern of the matrix changed"};
  const std::size_t bytes = f.values.size() * sizeof(double);
  if (f.numeric != nullptr && std::memcmp(f.values.data(), matrix.values.data(), bytes) == 0) return true;
  std::memcpy(f.values.data(), matrix.values.data(), bytes);
  ++f.count;
  const bool done = (f.numeric != nullptr && f.refactorise()) || f.factorise_anew();
  if (!done) klu_free_numeric(&f.numeric, &f.common);
  return done;
}

void Factorisation::solve(Vector& x) const {
  Factors& f = *factors_;
  if (f.numeric == nullptr) throw std::logic_error{"Factorisation: solve() before a successful factorise()"};
  klu_solve(f.symbolic, f.numeric, static_cast<int>(x.size()), 1, x.data(), &f.common);
}

long Factorisation::count() const { return factors_->count; }

}  // namespace moat
