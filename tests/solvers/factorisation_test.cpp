#include "solvers/factorisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <stdexcept>
#include <utility>

#include "counted_allocations.hpp"
#include "matrices.hpp"

namespace moat {
namespace {

using testing::entry;
using testing::full_pattern;
using testing::random_matrix;

Vector right_hand_side(int size) { return Vector::LinSpaced(size, -1.0, 2.0).array().sin(); }

// Largest difference from Eigen's dense LU, over the largest entry of its solution.
double difference_from_dense(const Factorisation& factors, const SparseMatrix& matrix) {
  const Vector b = right_hand_side(static_cast<int>(matrix.rows()));
  const Vector expected = Eigen::MatrixXd{matrix}.fullPivLu().solve(b);
  Vector x = b;
  factors.solve(x);
  return (x - expected).lpNorm<Eigen::Infinity>() / expected.lpNorm<Eigen::Infinity>();
}

// Rows (0 1; 1 0) and its like: no pivot stands on the diagonal.
SparseMatrix two_by_two(double a, double b, double c, double d) {
  SparseMatrix matrix = full_pattern(2);
  entry(matrix, 0, 0) = a;
  entry(matrix, 0, 1) = b;
  entry(matrix, 1, 0) = c;
  entry(matrix, 1, 1) = d;
  return matrix;
}

TEST(Factorisation, AgreesWithDenseLu) {
  for (const bool symmetric : {true, false})
    for (const int size : {1, 2, 7, 60, 150}) {
      const SparseMatrix matrix = random_matrix(size, symmetric, static_cast<unsigned>(size));
      Factorisation factors;
      ASSERT_TRUE(factors.factorise(matrix)) << size;
      EXPECT_LT(difference_from_dense(factors, matrix), 1e-12) << size << (symmetric ? " symmetric" : " unsymmetric");
    }
}

TEST(Factorisation, SolvesForSeveralRightSides) {
  const SparseMatrix matrix = random_matrix(60, false, 5U);
  Factorisation factors;
  Eigen::MatrixXd x = Eigen::MatrixXd::Identity(60, 7);
  EXPECT_THROW(factors.solve(x), std::logic_error);
  ASSERT_TRUE(factors.factorise(matrix));
  factors.solve(x);
  EXPECT_LT((matrix * x - Eigen::MatrixXd::Identity(60, 7)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Factorisation, NeedsNoPivotOnTheDiagonal) {
  const SparseMatrix matrix = two_by_two(0.0, 2.0, -3.0, 0.0);
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(matrix));
  Vector x{{4.0, 6.0}};
  factors.solve(x);
  EXPECT_DOUBLE_EQ(x[0], -2.0);
  EXPECT_DOUBLE_EQ(x[1], 2.0);
}

TEST(Factorisation, CountsWhatItComputes) {
  const SparseMatrix matrix = random_matrix(20, true, 3);
  Factorisation factors;
  EXPECT_EQ(factors.count(), 0);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(factors.factorise(matrix));
  EXPECT_EQ(factors.count(), 3);
  EXPECT_EQ(factors.pivot_searches(), 1);
}

// A contact is many times stiffer than the building. The matrix stays symmetric and positive: its pivots stay good.
TEST(Factorisation, KeepsItsPivotsBesideAVeryStiffContact) {
  SparseMatrix matrix = testing::chain_stiffness(6, 3.0, 3.0);
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(matrix));
  entry(matrix, 2, 2) += 1e12;
  ASSERT_TRUE(factors.factorise(matrix));
  EXPECT_EQ(factors.pivot_searches(), 1);
  EXPECT_LT(difference_from_dense(factors, matrix), 1e-12);
}

TEST(Factorisation, SingularAtFirstThenRecovers) {
  Factorisation factors;
  EXPECT_FALSE(factors.factorise(two_by_two(1.0, 2.0, 2.0, 4.0)));
  EXPECT_FALSE(factors.factorise(two_by_two(1.0, 2.0, 2.0, 4.0)));
  Vector x{{1.0, 1.0}};
  EXPECT_THROW(factors.solve(x), std::logic_error);
  const SparseMatrix regular = two_by_two(1.0, 2.0, 2.0, 5.0);
  ASSERT_TRUE(factors.factorise(regular));
  EXPECT_LT(difference_from_dense(factors, regular), 1e-14);
}

TEST(Factorisation, SingularInBetweenThenRecovers) {
  SparseMatrix matrix = random_matrix(20, false, 4);
  const SparseMatrix regular = matrix;
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(matrix));
  for (int row = 0; row < matrix.rows(); ++row)
    if (Eigen::MatrixXd{matrix}(row, 8) != 0.0) entry(matrix, row, 8) = 0.0;
  EXPECT_FALSE(factors.factorise(matrix));
  EXPECT_FALSE(factors.factorise(matrix));
  ASSERT_TRUE(factors.factorise(regular));
  EXPECT_LT(difference_from_dense(factors, regular), 1e-12);
}

TEST(Factorisation, RefusesWhatIsNotFinite) {
  const SparseMatrix regular = random_matrix(20, false, 5);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix matrix = regular;
    entry(matrix, 11, 11) = bad;
    Factorisation first;
    EXPECT_FALSE(first.factorise(matrix)) << bad;
    Factorisation later;
    ASSERT_TRUE(later.factorise(regular));
    EXPECT_FALSE(later.factorise(matrix)) << bad;
    ASSERT_TRUE(later.factorise(regular));
    EXPECT_LT(difference_from_dense(later, regular), 1e-12);
  }
}

TEST(Factorisation, FindsNewPivotsWhereThoseOfTheFirstMatrixBecamePoor) {
  // The first matrix takes its pivots from the diagonal; the second has almost nothing there.
  const SparseMatrix diagonal = two_by_two(1.0, 0.1, 0.1, 1.0);
  const SparseMatrix opposite = two_by_two(1e-17, 1.0, 1.0, 1e-17);
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(diagonal));
  ASSERT_TRUE(factors.factorise(opposite));
  EXPECT_EQ(factors.pivot_searches(), 2);
  EXPECT_LT(difference_from_dense(factors, opposite), 1e-14);
  // A pivot that is exactly zero.
  const SparseMatrix swapped = two_by_two(0.0, 1.0, 1.0, 0.0);
  ASSERT_TRUE(factors.factorise(diagonal));
  ASSERT_TRUE(factors.factorise(swapped));
  EXPECT_LT(difference_from_dense(factors, swapped), 1e-14);
}

TEST(Factorisation, RefusesAnotherPattern) {
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(random_matrix(20, true, 6)));
  EXPECT_THROW(static_cast<void>(factors.factorise(random_matrix(20, true, 7))), std::logic_error);
}

TEST(Factorisation, MovesWithItsFactors) {
  const SparseMatrix matrix = random_matrix(20, true, 8);
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(matrix));
  const Factorisation moved = std::move(factors);
  EXPECT_EQ(moved.count(), 1);
  EXPECT_LT(difference_from_dense(moved, matrix), 1e-12);
}

TEST(Factorisation, DoesNotAllocateWhenItRefactorisesAndSolves) {
  SparseMatrix matrix = random_matrix(60, false, 9);
  Factorisation factors;
  ASSERT_TRUE(factors.factorise(matrix));
  Vector x = right_hand_side(60);
  const long before = testing::count_of_allocations();
  bool done = true;
  for (int i = 0; i < 10; ++i) {
    matrix.valuePtr()[0] += 0.1;
    done = done && factors.factorise(matrix);
    factors.solve(x);
  }
  EXPECT_EQ(testing::count_of_allocations(), before);
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace moat
