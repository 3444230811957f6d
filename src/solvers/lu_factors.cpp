#include "solvers/lu_factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moat {
namespace {

std::vector<int> inverse_of(const std::vector<int>& permutation) {
  std::vector<int> inverse(permutation.size());
  for (std::size_t k = 0; k < permutation.size(); ++k)
    inverse[static_cast<std::size_t>(permutation[k])] = static_cast<int>(k);
  return inverse;
}

}  // namespace

LuFactors::LuFactors(Columns lower, Columns upper, std::vector<int> rows, std::vector<int> columns,
                     const SparsityPattern& pattern, int condensed)
    : lower_{std::move(lower)},
      upper_{std::move(upper)},
      rows_{std::move(rows)},
      columns_{std::move(columns)},
      entry_rows_{pattern.row_indices},
      condensed_{condensed} {
  const int count = static_cast<int>(columns_.size());
  const std::vector<int> positions_of_rows = inverse_of(rows_);
  for (int& row : entry_rows_) row = positions_of_rows[static_cast<std::size_t>(row)];
  lower_.values.resize(lower_.rows.size());
  upper_.values.resize(upper_.rows.size());
  inverse_pivots_.setZero(count);
  work_.setZero(count);
  if (condensed_ == 0) return;
  share_.starts.push_back(0);
  const auto rows_of = [](const Columns& triangle, int k) {
    const auto column = static_cast<std::size_t>(k);
    return std::pair{triangle.rows.begin() + triangle.starts[column],
                     triangle.rows.begin() + triangle.starts[column + 1]};
  };
  for (int k = condensed_; k < count; ++k) {
    const auto [begin, end] = rows_of(upper_, k);
    const auto split = std::lower_bound(begin, end, condensed_);
    upper_splits_.push_back(static_cast<int>(split - upper_.rows.begin()));
    share_.rows.insert(share_.rows.end(), split, end);
    share_.rows.push_back(k);
    const auto [below, last] = rows_of(lower_, k);
    share_.rows.insert(share_.rows.end(), below, last);
    share_.starts.push_back(static_cast<int>(share_.rows.size()));
  }
  share_.values.assign(share_.rows.size(), 0.0);
}

// Columns `first` and later of both factors. take_column(k, column) adds column k of A Q, without the multiples of
// other columns that some first entries of U stand for, and returns the place of the next entry.
template <class TakeColumn>
void LuFactors::eliminate(int first, const TakeColumn& take_column) {
  const int *lower_starts = lower_.starts.data(), *upper_starts = upper_.starts.data(),
            *lower_rows = lower_.rows.data(), *upper_rows = upper_.rows.data();
  double* __restrict column = work_.data();
  double* __restrict lower = lower_.values.data();
  double* __restrict upper = upper_.values.data();
  double* __restrict inverse_pivots = inverse_pivots_.data();
  const int count = static_cast<int>(columns_.size());
  for (int k = first; k < count; ++k) {
    int p = take_column(k, column);
    for (const int end = upper_starts[k + 1]; p < end; ++p) {
      const int before = upper_rows[p];
      const double factor = std::exchange(column[before], 0.0);
      upper[p] = factor;
      for (int q = lower_starts[before], last = lower_starts[before + 1]; q < last; ++q)
        column[lower_rows[q]] -= factor * lower[q];
    }
    const double inverse_pivot = 1.0 / std::exchange(column[k], 0.0);
    inverse_pivots[k] = inverse_pivot;
    for (int q = lower_starts[k], last = lower_starts[k + 1]; q < last; ++q)
      lower[q] = inverse_pivot * std::exchange(column[lower_rows[q]], 0.0);
  }
}

bool LuFactors::refactorise(const SparseMatrix& matrix) {
  has_share_ = false;
  const int *starts = matrix.column_starts().data(), *columns = columns_.data(), *entry_rows = entry_rows_.data(),
            *upper_starts = upper_.starts.data();
  const double* values = matrix.values.data();
  eliminate(0, [&](int k, double* column) {
    for (int p = starts[columns[k]], end = starts[columns[k] + 1]; p < end; ++p) column[entry_rows[p]] = values[p];
    return upper_starts[k];
  });
  return has_good_pivots();
}

bool LuFactors::refactorise_condensed(const SparseMatrix& matrix) {
  if (condensed_ == 0) return refactorise(matrix);
  if (!has_share_) compute_share();
  const int *starts = matrix.column_starts().data(), *columns = columns_.data(), *entry_rows = entry_rows_.data(),
            *splits = upper_splits_.data(), *share_starts = share_.starts.data(), *share_rows = share_.rows.data();
  const double *values = matrix.values.data(), *share = share_.values.data();
  eliminate(condensed_, [&](int k, double* column) {
    const int of_share = k - condensed_;
    for (int p = share_starts[of_share]; p < share_starts[of_share + 1]; ++p) column[share_rows[p]] = share[p];
    for (int p = starts[columns[k]], end = starts[columns[k] + 1]; p < end; ++p)
      if (entry_rows[p] >= condensed_) column[entry_rows[p]] += values[p];
    return splits[of_share];
  });
  return has_good_pivots();
}

// From L21 and U12, which are factors of the last matrix.
void LuFactors::compute_share() {
  const int *lower_starts = lower_.starts.data(), *lower_rows = lower_.rows.data();
  const int count = static_cast<int>(columns_.size());
  double* column = work_.data();
  for (int k = condensed_; k < count; ++k) {
    const auto of_share = static_cast<std::size_t>(k - condensed_);
    for (int p = upper_.starts[static_cast<std::size_t>(k)]; p < upper_splits_[of_share]; ++p) {
      const auto entry = static_cast<std::size_t>(p);
      const int before = upper_.rows[entry];
      for (int q = lower_starts[before]; q < lower_starts[before + 1]; ++q)
        if (lower_rows[q] >= condensed_)
          column[lower_rows[q]] -= upper_.values[entry] * lower_.values[static_cast<std::size_t>(q)];
    }
    for (int p = share_.starts[of_share]; p < share_.starts[of_share + 1]; ++p) {
      const auto entry = static_cast<std::size_t>(p);
      share_.values[entry] = std::exchange(column[share_.rows[entry]], 0.0);
    }
  }
  has_share_ = true;
}

bool LuFactors::has_good_pivots() const {
  constexpr double poor = 1e-13;
  const auto magnitudes = inverse_pivots_.cwiseAbs();
  // The sum is not finite if any of them is not.
  return std::isfinite(magnitudes.sum()) && magnitudes.minCoeff() > poor * magnitudes.maxCoeff();
}

void LuFactors::solve(Vector& x) const {
  const int count = static_cast<int>(columns_.size());
  const int *rows = rows_.data(), *columns = columns_.data(), *lower_starts = lower_.starts.data(),
            *upper_starts = upper_.starts.data(), *lower_rows = lower_.rows.data(), *upper_rows = upper_.rows.data();
  const double *lower = lower_.values.data(), *upper = upper_.values.data(), *inverse_pivots = inverse_pivots_.data();
  double* __restrict y = work_.data();
  for (int k = 0; k < count; ++k) y[k] = x[rows[k]];
  for (int k = 0; k < count; ++k) {
    const double value = y[k];
    for (int q = lower_starts[k]; q < lower_starts[k + 1]; ++q) y[lower_rows[q]] -= lower[q] * value;
  }
  for (int k = count - 1; k >= 0; --k) {
    const double value = y[k] * inverse_pivots[k];
    y[k] = 0.0;
    for (int p = upper_starts[k]; p < upper_starts[k + 1]; ++p) y[upper_rows[p]] -= upper[p] * value;
    x[columns[k]] = value;
  }
}

}  // namespace moat
