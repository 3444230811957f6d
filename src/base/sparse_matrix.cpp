#include "base/sparse_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace moat {

int SparsityPattern::slot(int row, int column) const {
  if (row == ground_index || column == ground_index) return nonzeros();
  const auto first = row_indices.begin() + column_starts[static_cast<std::size_t>(column)];
  const auto last = row_indices.begin() + column_starts[static_cast<std::size_t>(column) + 1];
  const auto found = std::lower_bound(first, last, row);
  if (found == last || *found != row)
    throw std::out_of_range{"SparsityPattern: entry (" + std::to_string(row) + ", " + std::to_string(column) +
                            ") is not in the pattern"};
  return static_cast<int>(found - row_indices.begin());
}

PatternBuilder::PatternBuilder(int size) : size_{size} { pairs_.reserve(static_cast<std::size_t>(size) * 4); }

void PatternBuilder::couple(int a, int b) {
  if (a == ground_index || b == ground_index || a == b) return;
  pairs_.emplace_back(a, b);
}

std::shared_ptr<const SparsityPattern> PatternBuilder::build() {
  auto pattern = std::make_shared<SparsityPattern>();
  pattern->size = size_;
  const auto size = static_cast<std::size_t>(size_);
  // Rows of every column, as often as they were coupled, are put in from the end of the column: `places` first holds
  // the ends of columns, at last their starts.
  std::vector<std::size_t> places(size + 1, 0);
  const auto for_each_entry = [&](const auto& action) {
    for (int i = 0; i < size_; ++i) action(i, places[static_cast<std::size_t>(i)]);
    for (const auto& [a, b] : pairs_) {
      action(a, places[static_cast<std::size_t>(b)]);
      action(b, places[static_cast<std::size_t>(a)]);
    }
  };
  for_each_entry([](int, std::size_t& count) { ++count; });
  std::partial_sum(places.begin(), places.end(), places.begin());
  std::vector<int> rows(places.back());
  for_each_entry([&](int row, std::size_t& place) { rows[--place] = row; });
  pattern->column_starts.reserve(size + 1);
  pattern->row_indices.reserve(rows.size());
  for (std::size_t column = 0; column < size; ++column) {
    const auto row = [&](std::size_t place) { return rows.begin() + static_cast<std::ptrdiff_t>(place); };
    const auto begin = row(places[column]), end = row(places[column + 1]);
    std::sort(begin, end);
    pattern->column_starts.push_back(pattern->nonzeros());
    pattern->row_indices.insert(pattern->row_indices.end(), begin, std::unique(begin, end));
  }
  pattern->column_starts.push_back(pattern->nonzeros());
  return pattern;
}

}  // namespace moat
