#include "model/couplings.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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
