#include "solvers/lu_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "matrices.hpp"

namespace moat {
namespace {

using testing::entry;
using testing::full_pattern;

constexpr int size = 4;

// Rows and columns of A in these orders; all entries of both factors are in their pattern.
LuFactors full_factors(std::vector<int> rows, std::vector<int> columns, int condensed) {
  LuFactors::Columns lower{.starts = {0}, .rows = {}, .values = {}}, upper = lower;
  for (int k = 0; k < size; ++k) {
    for (int row = 0; row < size; ++row)
      if (row != k) (row > k ? lower : upper).rows.push_back(row);
    for (LuFactors::Columns* triangle : {&lower, &upper}) {
      triangle->starts.push_back(static_cast<int>(triangle->rows.size()));
      triangle->values.resize(triangle->rows.size());
    }
  }
  return {std::move(lower), std::move(upper), std::move(rows), std::move(columns), *full_pattern(size).pattern(),
          condensed};
}

// Every entry differs, and the diagonal is strong.
SparseMatrix unsymmetric_matrix() {
  SparseMatrix matrix = full_pattern(size);
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < size; ++k) entry(matrix, i, k) = i == k ? 5.0 + i : 1.0 / (1.0 + i + 2.0 * k);
  return matrix;
}

double difference_from_dense(const LuFactors& factors, const SparseMatrix& matrix) {
  const Vector b{{1.0, -2.0, 0.5, 3.0}};
  Vector x = b;
  factors.solve(x);
  return (x - Eigen::MatrixXd{matrix.view()}.fullPivLu().solve(b)).lpNorm<Eigen::Infinity>();
}

TEST(LuFactors, SolveForEveryOrderAndSizeOfTheCondensedPart) {
  for (const std::vector<int>& order : std::vector<std::vector<int>>{{0, 1, 2, 3}, {3, 1, 0, 2}})
    for (int condensed = 0; condensed <= size; ++condensed) {
      SparseMatrix matrix = unsymmetric_matrix();
      LuFactors factors = full_factors(order, order, condensed);
      ASSERT_TRUE(factors.refactorise(matrix));
      EXPECT_LT(difference_from_dense(factors, matrix), 1e-14) << condensed;
    }
}

TEST(LuFactors, CondensedPartAloneAnyNumberOfTimes) {
  const std::vector<int> order{3, 1, 0, 2};
  for (int condensed = 0; condensed <= size; ++condensed) {
    SparseMatrix matrix = unsymmetric_matrix();
    LuFactors factors = full_factors(order, order, condensed);
    for (int round = 0; round < 4; ++round) {
      // All entries change, then three times those of A22 alone, which begins behind `condensed` rows and columns.
      for (int row = round == 0 ? 0 : condensed; row < size; ++row)
        for (int column = round == 0 ? 0 : condensed; column < size; ++column)
          entry(matrix, order[static_cast<std::size_t>(row)], order[static_cast<std::size_t>(column)]) *=
              1.0 + 0.1 * round + 0.03 * row + 0.02 * column;
      ASSERT_TRUE(round == 0 ? factors.refactorise(matrix) : factors.refactorise_condensed(matrix));
      EXPECT_LT(difference_from_dense(factors, matrix), 1e-14) << condensed << ", round " << round;
    }
    // The condensed part of the last matrix is not used for another one.
    for (double& value : matrix.values) value *= 1.5;
    ASSERT_TRUE(factors.refactorise(matrix));
    ASSERT_TRUE(factors.refactorise_condensed(matrix));
    EXPECT_LT(difference_from_dense(factors, matrix), 1e-14) << condensed;
  }
}

TEST(LuFactors, RowsAndColumnsInOtherOrders) {
  const SparseMatrix matrix = unsymmetric_matrix();
  LuFactors factors = full_factors({2, 0, 1, 3}, {3, 0, 1, 2}, 0);
  ASSERT_TRUE(factors.refactorise(matrix));
  EXPECT_LT(difference_from_dense(factors, matrix), 1e-13);
}

TEST(LuFactors, RefusePivotsThatAreZeroPoorOrNotFinite) {
  for (const double pivot :
       {0.0, 1e-14, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix matrix = full_pattern(size);
    for (int i = 0; i < size; ++i) entry(matrix, i, i) = i == 2 ? pivot : 1.0;
    LuFactors factors = full_factors({0, 1, 2, 3}, {0, 1, 2, 3}, 2);
    EXPECT_FALSE(factors.refactorise(matrix)) << pivot;
  }
  EXPECT_TRUE(LuFactors{}.empty());
}

}  // namespace
}  // namespace moat
