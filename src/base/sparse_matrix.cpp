#include "base/sparse_matrix.hpp"

#include <algorithm>
#include <stdexcept>

namespace moat {
namespace {

std::uint64_t key(int row, int column) {
  return (static_cast<std::uint64_t>(column) << 32) | static_cast<std::uint32_t>(row);
}

}  // namespace

int SparseMatrix::slot(int row, int column) const {
  if (row == ground_index || column == ground_index) return nonzeros();
  const auto first = row_indices.begin() + column_starts[static_cast<std::size_t>(column)];
  const auto last = row_indices.begin() + column_starts[static_cast<std::size_t>(column) + 1];
  const auto found = std::lower_bound(first, last, row);
  if (found == last || *found != row)
    throw std::out_of_range{"SparseMatrix: entry (" + std::to_string(row) + ", " + std::to_string(column) +
                            ") is not in the pattern"};
  return static_cast<int>(found - row_indices.begin());
}

PatternBuilder::PatternBuilder(int size) : size_{size}, coupled_(static_cast<std::size_t>(size), false) {
  entries_.reserve(static_cast<std::size_t>(size) * 4);
  for (int i = 0; i < size; ++i) entries_.push_back(key(i, i));
}

void PatternBuilder::couple(int a, int b) {
  for (const int end : {a, b})
    if (end != ground_index) coupled_[static_cast<std::size_t>(end)] = true;
  if (a == ground_index || b == ground_index || a == b) return;
  entries_.push_back(key(a, b));
  entries_.push_back(key(b, a));
}

SparseMatrix PatternBuilder::build() {
  std::sort(entries_.begin(), entries_.end());
  entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
  SparseMatrix matrix;
  matrix.size = size_;
  matrix.column_starts.assign(static_cast<std::size_t>(size_) + 1, 0);
  matrix.row_indices.reserve(entries_.size());
  for (const std::uint64_t entry : entries_) {
    matrix.row_indices.push_back(static_cast<int>(entry & 0xffffffffu));
    ++matrix.column_starts[static_cast<std::size_t>(entry >> 32) + 1];
  }
  for (std::size_t column = 0; column < static_cast<std::size_t>(size_); ++column)
    matrix.column_starts[column + 1] += matrix.column_starts[column];
  matrix.values.assign(entries_.size() + 1, 0.0);
  return matrix;
}

}  // namespace moat
