#include "model/couplings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <stdexcept>
#include <vector>

namespace moat {
namespace {

// 0 - 1 - 2   3: a chain, and one degree of freedom that couples to the ground only.
SparseMatrix chain_and_loner() {
  Couplings couplings{4};
  couplings.couple(1, 0);
  couplings.couple(1, 2);
  couplings.couple(2, 1);
  couplings.couple(3, ground_index);
  couplings.couple(ground_index, ground_index);
  return couplings.zero_matrix();
}

TEST(Couplings, GiveTheDiagonalAndBothSidesOnce) {
  const SparseMatrix matrix = chain_and_loner();
  ASSERT_TRUE(matrix.isCompressed());
  ASSERT_EQ(matrix.cols(), 4);
  ASSERT_EQ(matrix.nonZeros(), 8);
  const int *starts = matrix.outerIndexPtr(), *rows = matrix.innerIndexPtr();
  EXPECT_EQ(std::vector<int>(starts, starts + 5), (std::vector<int>{0, 2, 5, 7, 8}));
  EXPECT_EQ(std::vector<int>(rows, rows + 8), (std::vector<int>{0, 1, 0, 1, 2, 1, 2, 3}));
  EXPECT_TRUE((matrix.coeffs() == 0.0).all());
}

TEST(EntryPosition, IsThatAmongTheValuesAndNoneForTheGround) {
  const SparseMatrix matrix = chain_and_loner();
  int position = 0;
  for (int column = 0; column < 4; ++column)
    for (SparseMatrix::InnerIterator entry{matrix, column}; entry; ++entry)
      EXPECT_EQ(entry_position(matrix, static_cast<int>(entry.row()), column), position++);
  for (const int i : {0, 1, 2, 3, ground_index}) {
    EXPECT_EQ(entry_position(matrix, ground_index, i), -1);
    EXPECT_EQ(entry_position(matrix, i, ground_index), -1);
  }
}

TEST(EntryPosition, IsRefusedForAnEntryThatTheMatrixDoesNotHave) {
  const SparseMatrix matrix = chain_and_loner();
  EXPECT_THROW(static_cast<void>(entry_position(matrix, 0, 2)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(entry_position(matrix, 3, 0)), std::out_of_range);
  // Beyond the last row of the last column: nothing there to look at.
  EXPECT_THROW(static_cast<void>(entry_position(matrix, 4, 3)), std::out_of_range);
}

TEST(EntryPosition, OfALargeMatrixDoesNotMixRowsAndColumns) {
  Couplings couplings{100000};
  couplings.couple(99999, 70000);
  const SparseMatrix matrix = couplings.zero_matrix();
  EXPECT_EQ(matrix.nonZeros(), 100002);
  EXPECT_EQ(matrix.innerIndexPtr()[entry_position(matrix, 99999, 70000)], 99999);
  EXPECT_EQ(entry_position(matrix, 70000, 99999), 100000);
}

}  // namespace
}  // namespace moat
