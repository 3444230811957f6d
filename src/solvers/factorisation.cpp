#include "solvers/factorisation.hpp"

#include <klu.h>

#include <stdexcept>

namespace moat {
namespace {

// The growth of elements is the largest entry of U over the largest of A, column by column; KLU reports its inverse. An
// inverse of 1e-6 leaves ten digits of a solution, which is enough for a Newton direction. Symmetric positive matrices
// never grow, however much stiffer a contact is than the building: the condition number would be the wrong guard.
constexpr double smallest_inverse_growth = 1e-6;

// KLU takes pointers to variables, and does not write there.
int* starts_of(const SparseMatrix& matrix) { return const_cast<int*>(matrix.outerIndexPtr()); }
int* rows_of(const SparseMatrix& matrix) { return const_cast<int*>(matrix.innerIndexPtr()); }
double* values_of(const SparseMatrix& matrix) { return const_cast<double*>(matrix.valuePtr()); }

}  // namespace

struct Factorisation::Klu {
  klu_common common{};
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
  Eigen::Index entries = 0;
  long count = 0, pivot_searches = 0;
  Vector searched;          // values of the last matrix with new pivots
  bool refactored = false;  // with these pivots since

  Klu() {
    klu_defaults(&common);
    // A structure couples all its degrees of freedom: there are no blocks to find. Masses on the
    // diagonal keep rows of similar size, so scaling would only cost time.
    common.btf = 0;
    common.scale = -1;
  }
  ~Klu() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;

  void analyse(const SparseMatrix& matrix) {
    entries = matrix.nonZeros();
    symbolic = klu_analyze(static_cast<int>(matrix.rows()), starts_of(matrix), rows_of(matrix), &common);
    if (symbolic == nullptr) throw std::logic_error{"Factorisation: KLU cannot analyse the pattern of the matrix"};
  }

  // KLU takes a pivot that is not a number for one that is not zero; its condition estimate does not.
  [[nodiscard]] bool has_regular_pivots() {
    return common.status == KLU_OK && klu_rcond(symbolic, numeric, &common) != 0 && common.rcond > 0.0;
  }

  [[nodiscard]] bool factorise_with_old_pivots(const SparseMatrix& matrix) {
    int *starts = starts_of(matrix), *rows = rows_of(matrix);
    double* values = values_of(matrix);
    return numeric != nullptr && klu_refactor(starts, rows, values, symbolic, numeric, &common) != 0 &&
           klu_rgrowth(starts, rows, values, symbolic, numeric, &common) != 0 &&
           common.rgrowth >= smallest_inverse_growth && has_regular_pivots();
  }

  [[nodiscard]] bool factorise_with_new_pivots(const SparseMatrix& matrix) {
    ++pivot_searches;
    searched = matrix.coeffs();
    refactored = false;
    klu_free_numeric(&numeric, &common);
    numeric = klu_factor(starts_of(matrix), rows_of(matrix), values_of(matrix), symbolic, &common);
    if (numeric != nullptr && has_regular_pivots()) return true;
    klu_free_numeric(&numeric, &common);
    return false;
  }
};

Factorisation::Factorisation() : klu_{std::make_unique<Klu>()} {}
Factorisation::~Factorisation() = default;
Factorisation::Factorisation(Factorisation&&) noexcept = default;
Factorisation& Factorisation::operator=(Factorisation&&) noexcept = default;

bool Factorisation::factorise(const SparseMatrix& matrix) {
  if (klu_->symbolic == nullptr) klu_->analyse(matrix);
  if (klu_->entries != matrix.nonZeros()) throw std::logic_error{"Factorisation: the pattern of the matrix changed"};
  ++klu_->count;
  klu_->refactored = klu_->factorise_with_old_pivots(matrix);
  return klu_->refactored || klu_->factorise_with_new_pivots(matrix);
}

void Factorisation::archive(StateArchive& archive, const SparseMatrix& last) {
  bool has_factors = klu_->numeric != nullptr, refactored = klu_->refactored;
  archive(has_factors, refactored, klu_->searched);
  if (archive.reads() && has_factors) {
    SparseMatrix matrix = last;
    matrix.coeffs() = klu_->searched;
    if (klu_->symbolic == nullptr) klu_->analyse(matrix);
    klu_->refactored = klu_->factorise_with_new_pivots(matrix) && refactored;
    if (refactored) static_cast<void>(klu_->factorise_with_old_pivots(last));
  }
  archive(klu_->count, klu_->pivot_searches);
}

void Factorisation::solve(Vector& x) const {
  if (klu_->numeric == nullptr) throw std::logic_error{"Factorisation: solve() before a successful factorise()"};
  klu_solve(klu_->symbolic, klu_->numeric, static_cast<int>(x.size()), 1, x.data(), &klu_->common);
}

void Factorisation::solve(Eigen::MatrixXd& x) const {
  if (klu_->numeric == nullptr) throw std::logic_error{"Factorisation: solve() before a successful factorise()"};
  klu_solve(klu_->symbolic, klu_->numeric, static_cast<int>(x.rows()), static_cast<int>(x.cols()), x.data(),
            &klu_->common);
}

long Factorisation::count() const { return klu_->count; }
long Factorisation::pivot_searches() const { return klu_->pivot_searches; }

}  // namespace moat
