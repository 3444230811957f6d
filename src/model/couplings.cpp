#include "model/couplings.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace moat {

int entry_position(const SparseMatrix& matrix, int row, int column) {
  if (row == ground_index || column == ground_index) return -1;
  const int* rows = matrix.innerIndexPtr();
  const int *first = rows + matrix.outerIndexPtr()[column], *last = rows + matrix.outerIndexPtr()[column + 1];
  const int* found = std::lower_bound(first, last, row);
  if (found == last || *found != row)
    throw std::out_of_range{"the matrix has no entry (" + std::to_string(row) + ", " + std::to_string(column) + ")"};
  return static_cast<int>(found - rows);
}

Couplings::Couplings(int size) : size_{size} {
  for (int i = 0; i < size; ++i) entries_.emplace_back(i, i, 0.0);
}

void Couplings::couple(int a, int b) {
  if (a == ground_index || b == ground_index || a == b) return;
  entries_.emplace_back(a, b, 0.0);
  entries_.emplace_back(b, a, 0.0);
}

SparseMatrix Couplings::zero_matrix() const {
  SparseMatrix matrix{size_, size_};
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  return matrix;
}

}  // namespace moat
