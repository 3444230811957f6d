#include "solvers/factorisation.hpp"

#include <camd.h>
#include <klu.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "solvers/lu_factors.hpp"

namespace moat {

struct Factorisation::Factors {
  klu_common common{};
  std::vector<int> changing;                       // columns eliminated last
  std::shared_ptr<const SparsityPattern> pattern;  // of the matrix of `lu`
  LuFactors lu;
  long count = 0;

  Factors() {
    klu_defaults(&common);
    // A structure couples all its degrees of freedom: there are no blocks to find. Masses on the
    // diagonal keep rows of similar size, so scaling would only cost time.
    common.btf = 0;
    common.scale = -1;
  }

  // KLU and CAMD take pointers to variables, and do not write there.
  [[nodiscard]] int* starts() const { return const_cast<int*>(pattern->column_starts.data()); }
  [[nodiscard]] int* rows() const { return const_cast<int*>(pattern->row_indices.data()); }

  // Null where that fails.
  klu_symbolic* analyse() {
    if (changing.empty() || changing.size() == static_cast<std::size_t>(pattern->size))
      return klu_analyze(pattern->size, starts(), rows(), &common);
    std::vector<int> order(static_cast<std::size_t>(pattern->size)), group(order.size(), 0);
    for (const int column : changing) group[static_cast<std::size_t>(column)] = 1;
    if (camd_order(pattern->size, starts(), rows(), order.data(), nullptr, nullptr, group.data()) != CAMD_OK)
      return nullptr;
    return klu_analyze_given(pattern->size, starts(), rows(), order.data(), order.data(), &common);
  }

  // Factors of a matrix that differs from the last one in the changing columns only, or in any.
  bool factorise(const SparseMatrix& matrix, bool all_columns) {
    ++count;
    if (lu.empty()) return factorise_with_new_permutations(matrix);
    if (pattern->nonzeros() != matrix.nonzeros())
      throw std::logic_error{"Factorisation: the pattern of the matrix changed"};
    return (all_columns ? lu.refactorise(matrix) : lu.refactorise_condensed(matrix)) ||
           factorise_with_new_permutations(matrix);
  }

  // Permutations and pattern by KLU, which needs more memory than the factors: none of it stays.
  bool factorise_with_new_permutations(const SparseMatrix& matrix) {
    lu = {};
    pattern = matrix.pattern();
    klu_symbolic* symbolic = analyse();
    if (symbolic == nullptr) return false;
    klu_numeric* numeric = klu_factor(starts(), rows(), const_cast<double*>(matrix.values.data()), symbolic, &common);
    // KLU takes a pivot that is not a number for one that is not zero; its condition estimate does not.
    const bool good = numeric != nullptr && common.status == KLU_OK && klu_rcond(symbolic, numeric, &common) != 0 &&
                      common.rcond > 0.0 && klu_sort(symbolic, numeric, &common) != 0;
    if (good) lu = on_pattern_of(*numeric, *symbolic);
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
    if (good && lu.refactorise(matrix)) return true;
    lu = {};
    return false;
  }

  LuFactors on_pattern_of(klu_numeric& numeric, klu_symbolic& symbolic) {
    const auto size = static_cast<std::size_t>(pattern->size);
    LuFactors::Columns lower, upper;
    for (auto [columns, entries] : {std::pair{&lower, numeric.lnz}, {&upper, numeric.unz}}) {
      columns->starts.resize(size + 1);
      columns->rows.resize(static_cast<std::size_t>(entries));
    }
    std::vector<int> rows(size), columns(size);
    // Values are computed again: those of both triangles go to the same place.
    std::vector<double> unused(static_cast<std::size_t>(std::max(numeric.lnz, numeric.unz)));
    if (klu_extract(&numeric, &symbolic, lower.starts.data(), lower.rows.data(), unused.data(), upper.starts.data(),
                    upper.rows.data(), unused.data(), nullptr, nullptr, nullptr, rows.data(), columns.data(), nullptr,
                    nullptr, &common) == 0)
      throw std::logic_error{"Factorisation: KLU's factors could not be read"};
    without_diagonal(lower);
    without_diagonal(upper);
    const int condensed = unchanging_first(rows, columns) ? pattern->size - static_cast<int>(changing.size()) : 0;
    return {std::move(lower), std::move(upper), std::move(rows), std::move(columns), *pattern, condensed};
  }

  // Whether rows and columns that change are the last ones in order of elimination.
  [[nodiscard]] bool unchanging_first(const std::vector<int>& rows, const std::vector<int>& columns) const {
    const auto last = static_cast<std::ptrdiff_t>(changing.size());
    for (const std::vector<int>* order : {&rows, &columns}) {
      std::vector<int> tail(order->end() - last, order->end());
      std::ranges::sort(tail);
      if (tail != changing) return false;
    }
    return true;
  }

  static void without_diagonal(LuFactors::Columns& triangle) {
    std::size_t kept = 0, entry = 0;
    for (std::size_t k = 0; k + 1 < triangle.starts.size(); ++k) {
      triangle.starts[k] = static_cast<int>(kept);
      for (const auto end = static_cast<std::size_t>(triangle.starts[k + 1]); entry < end; ++entry)
        if (triangle.rows[entry] != static_cast<int>(k)) triangle.rows[kept++] = triangle.rows[entry];
    }
    triangle.starts.back() = static_cast<int>(kept);
    triangle.rows.resize(kept);
    triangle.rows.shrink_to_fit();
  }
};

Factorisation::Factorisation() : factors_{std::make_unique<Factors>()} {}
Factorisation::Factorisation(std::vector<int> changing_columns) : Factorisation{} {
  factors_->changing = std::move(changing_columns);
}
Factorisation::~Factorisation() = default;
Factorisation::Factorisation(Factorisation&&) noexcept = default;
Factorisation& Factorisation::operator=(Factorisation&&) noexcept = default;

bool Factorisation::factorise(const SparseMatrix& matrix) { return factors_->factorise(matrix, true); }

bool Factorisation::factorise_changing(const SparseMatrix& matrix) { return factors_->factorise(matrix, false); }

void Factorisation::solve(Vector& x) const {
  if (factors_->lu.empty()) throw std::logic_error{"Factorisation: solve() before a successful factorise()"};
  factors_->lu.solve(x);
}

long Factorisation::count() const { return factors_->count; }

}  // namespace moat
