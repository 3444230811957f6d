#include "base/sparse_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

namespace moat {
namespace {

// 0 - 1 - 2   3: a chain, and one degree of freedom that couples to the ground only.
SparseMatrix chain_and_loner() {
  PatternBuilder builder{4};
  builder.couple(1, 0);
  builder.couple(1, 2);
  builder.couple(2, 1);
  builder.couple(3, ground_index);
  builder.couple(ground_index, ground_index);
  return builder.build();
}

TEST(SparseMatrix, HoldsTheDiagonalAndBothSidesOfACouplingOnce) {
  const SparseMatrix matrix = chain_and_loner();
  EXPECT_EQ(matrix.size(), 4);
  EXPECT_EQ(matrix.column_starts(), (std::vector<int>{0, 2, 5, 7, 8}));
  EXPECT_EQ(matrix.row_indices(), (std::vector<int>{0, 1, 0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(matrix.nonzeros(), 8);
}

TEST(SparseMatrix, StartsAtZeroWithOneMoreValueForTheGround) {
  const SparseMatrix matrix = chain_and_loner();
  EXPECT_EQ(matrix.values, std::vector<double>(9, 0.0));
}

TEST(SparseMatrix, SlotsAreDistinctAndThoseOfTheGroundAreTheLast) {
  const SparseMatrix matrix = chain_and_loner();
  std::vector<int> slots;
  for (int column = 0; column < 4; ++column)
    for (int k = matrix.column_starts()[static_cast<std::size_t>(column)];
         k < matrix.column_starts()[static_cast<std::size_t>(column) + 1]; ++k)
      slots.push_back(matrix.slot(matrix.row_indices()[static_cast<std::size_t>(k)], column));
  EXPECT_EQ(slots, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  for (const int i : {0, 1, 2, 3, ground_index}) {
    EXPECT_EQ(matrix.slot(ground_index, i), 8);
    EXPECT_EQ(matrix.slot(i, ground_index), 8);
  }
}

TEST(SparseMatrix, RefusesASlotOutsideThePattern) {
  const SparseMatrix matrix = chain_and_loner();
  EXPECT_THROW(static_cast<void>(matrix.slot(0, 2)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(matrix.slot(3, 0)), std::out_of_range);
  // Beyond the last row of the last column: nothing there to look at.
  EXPECT_THROW(static_cast<void>(matrix.slot(4, 3)), std::out_of_range);
}

TEST(SparseMatrix, ViewEqualsTheDenseMatrixThatWasScattered) {
  SparseMatrix matrix = chain_and_loner();
  Eigen::Matrix4d dense = Eigen::Matrix4d::Zero();
  // Unsymmetric, and onto the ground as elements do.
  const auto scatter = [&](int row, int column, double value) {
    matrix.values[static_cast<std::size_t>(matrix.slot(row, column))] += value;
    if (row != ground_index && column != ground_index) dense(row, column) += value;
  };
  double value = 1.0;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, ground_index}, {3, ground_index}, {0, 1}})
    for (const auto& [row, column] : {std::pair{a, a}, {a, b}, {b, a}, {b, b}}) scatter(row, column, value *= 1.5);
  EXPECT_EQ(Eigen::Matrix4d{matrix.view()}, dense);
}

TEST(SparseMatrix, IndicesOfALargePatternDoNotMixRowsAndColumns) {
  PatternBuilder builder{100000};
  builder.couple(99999, 70000);
  const SparseMatrix matrix = builder.build();
  EXPECT_EQ(matrix.nonzeros(), 100002);
  EXPECT_EQ(matrix.row_indices()[static_cast<std::size_t>(matrix.slot(99999, 70000))], 99999);
  EXPECT_EQ(matrix.slot(70000, 99999), 100000);
}

}  // namespace
}  // namespace moat
