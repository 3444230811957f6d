// Matrices to test solvers with.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <utility>
#include <vector>

#include "base/sparse_matrix.hpp"

namespace moat::testing {

/// An entry that the matrix has.
inline double& entry(SparseMatrix& matrix, int row, int column) { return matrix.coeffRef(row, column); }

/// Zero, with all entries.
inline SparseMatrix full_pattern(int size) {
  return 0.0 * SparseMatrix{Eigen::MatrixXd::Ones(size, size).sparseView()};
}

/// Zero, with these entries on both sides and the diagonal.
inline SparseMatrix pattern_of(int size, const std::vector<std::pair<int, int>>& couplings) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 0.0);
  for (const auto& [a, b] : couplings) {
    entries.emplace_back(a, b, 0.0);
    entries.emplace_back(b, a, 0.0);
  }
  SparseMatrix matrix{size, size};
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// A random pattern with about four couplings per row and entries from -1 to 1, those of the diagonal from 4 to 5.
inline SparseMatrix random_matrix(int size, bool symmetric, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> value{-1.0, 1.0};
  std::uniform_int_distribution<int> index{0, size - 1};
  std::vector<std::pair<int, int>> couplings;
  for (int i = 0; i < 2 * size; ++i)
    if (const int a = index(random), b = index(random); a != b) couplings.emplace_back(a, b);
  SparseMatrix matrix = pattern_of(size, couplings);
  for (const auto& [a, b] : couplings) {
    entry(matrix, a, b) = value(random);
    entry(matrix, b, a) = symmetric ? entry(matrix, a, b) : value(random);
  }
  for (int i = 0; i < size; ++i) entry(matrix, i, i) = 4.5 + 0.5 * value(random);
  return matrix;
}

/// Stiffness of masses in a row joined by springs; the first is also held to the ground by `foot`.
inline SparseMatrix chain_stiffness(int size, double spring, double foot) {
  std::vector<std::pair<int, int>> couplings;
  for (int i = 1; i < size; ++i) couplings.emplace_back(i - 1, i);
  SparseMatrix matrix = pattern_of(size, couplings);
  entry(matrix, 0, 0) = foot;
  for (int i = 1; i < size; ++i) {
    entry(matrix, i - 1, i - 1) += spring;
    entry(matrix, i, i) += spring;
    entry(matrix, i - 1, i) = entry(matrix, i, i - 1) = -spring;
  }
  return matrix;
}

}  // namespace moat::testing
