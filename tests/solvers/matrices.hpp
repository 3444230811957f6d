// Matrices to test solvers with.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "base/sparse_matrix.hpp"

namespace moat::testing {

inline double& entry(SparseMatrix& matrix, int row, int column) {
  return matrix.values[static_cast<std::size_t>(matrix.slot(row, column))];
}

/// Every entry of a full pattern is in it; all zero.
inline SparseMatrix full_pattern(int size) {
  PatternBuilder builder{size};
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < i; ++k) builder.couple(i, k);
  return builder.build();
}

/// A random pattern with about four couplings per row and entries from -1 to 1, those of the diagonal from 4 to 5.
inline SparseMatrix random_matrix(int size, bool symmetric, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> value{-1.0, 1.0};
  std::uniform_int_distribution<int> index{0, size - 1};
  std::vector<std::pair<int, int>> couplings;
  PatternBuilder builder{size};
  for (int i = 0; i < 2 * size; ++i) {
    const int a = index(random), b = index(random);
    if (a == b) continue;
    couplings.emplace_back(a, b);
    builder.couple(a, b);
  }
  SparseMatrix matrix = builder.build();
  for (const auto& [a, b] : couplings) {
    entry(matrix, a, b) = value(random);
    entry(matrix, b, a) = symmetric ? entry(matrix, a, b) : value(random);
  }
  for (int i = 0; i < size; ++i) entry(matrix, i, i) = 4.5 + 0.5 * value(random);
  return matrix;
}

/// Stiffness of masses in a row joined by springs; the first is also held to the ground by `foot`.
inline SparseMatrix chain_stiffness(int size, double spring, double foot) {
  PatternBuilder builder{size};
  for (int i = 1; i < size; ++i) builder.couple(i - 1, i);
  SparseMatrix matrix = builder.build();
  entry(matrix, 0, 0) = foot;
  for (int i = 1; i < size; ++i) {
    entry(matrix, i - 1, i - 1) += spring;
    entry(matrix, i, i) += spring;
    entry(matrix, i - 1, i) = entry(matrix, i, i - 1) = -spring;
  }
  return matrix;
}

}  // namespace moat::testing
