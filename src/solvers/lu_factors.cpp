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

LuFactors::LuFactors(Columns lower, Columns upper, std::vector<int> rows, std::vector<int> columns, int condensed)
    : lower_{std::move(lower)},
      upper_{std::move(upper)},
      rows_{std::move(rows)},
      columns_{std::move(columns)},
      positions_{inverse_of(columns_)},
      positions_of_rows_{inverse_of(rows_)},
      condensed_{condensed} {
  const int count = static_cast<int>(columns_.size());
  lower_.values.resize(lower_.rows.size());
  upper_.values.resize(upper_.rows.size());
  inverse_pivots_.setZero(count);
  work_.setZero(count);
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

bool LuFactors::refactorise(const SparseMatrix& matrix, int first) {
  const int *starts = matrix.column_starts().data(), *matrix_rows = matrix.row_indices().data(),
            *columns = columns_.data(), *position_of = positions_of_rows_.data(), *lower_starts = lower_.starts.data(),
            *upper_starts = upper_.starts.data(), *lower_rows = lower_.rows.data(), *upper_rows = upper_.rows.data(),
            *splits = upper_splits_.data(), *share_starts = share_.starts.data(), *share_rows = share_.rows.data();
  const double* values = matrix.values.data();
  double* __restrict column = work_.data();
  double* __restrict lower = lower_.values.data();
  double* __restrict upper = upper_.values.data();
  double* __restrict share = share_.values.data();
  double* __restrict inverse_pivots = inverse_pivots_.data();
  // Entries of column k of A Q in these rows of P A.
  const auto add_entries = [&](int k, int from, int to) {
    for (int p = starts[columns[k]]; p < starts[columns[k] + 1]; ++p)
      if (const int row = position_of[matrix_rows[p]]; row >= from && row < to) column[row] += values[p];
  };
  // Entries `from` to `to` of U; each takes its multiple of a column before from the column.
  const auto eliminate = [&](int from, int to) {
    for (int p = from; p < to; ++p) {
      const int before = upper_rows[p];
      const double factor = std::exchange(column[before], 0.0);
      upper[p] = factor;
      for (int q = lower_starts[before]; q < lower_starts[before + 1]; ++q) column[lower_rows[q]] -= factor * lower[q];
    }
  };
  const auto finish = [&](int k) {
    const double inverse_pivot = 1.0 / std::exchange(column[k], 0.0);
    inverse_pivots[k] = inverse_pivot;
    for (int q = lower_starts[k]; q < lower_starts[k + 1]; ++q)
      lower[q] = inverse_pivot * std::exchange(column[lower_rows[q]], 0.0);
  };
  const int count = matrix.size();
  for (int k = first; k < condensed_; ++k) {
    add_entries(k, 0, count);
    eliminate(upper_starts[k], upper_starts[k + 1]);
    finish(k);
  }
  const bool keeps_share = first >= condensed_;
  for (int k = std::max(first, condensed_); k < count; ++k) {
    const int of_share = k - condensed_, split = splits[of_share];
    if (keeps_share) {
      for (int p = share_starts[of_share]; p < share_starts[of_share + 1]; ++p) column[share_rows[p]] = share[p];
    } else {
      add_entries(k, 0, condensed_);
      eliminate(upper_starts[k], split);
      for (int p = share_starts[of_share]; p < share_starts[of_share + 1]; ++p) share[p] = column[share_rows[p]];
    }
    add_entries(k, condensed_, count);
    eliminate(split, upper_starts[k + 1]);
    finish(k);
  }
  return has_good_pivots();
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
