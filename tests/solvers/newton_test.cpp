#include "solvers/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "counted_allocations.hpp"
#include "matrices.hpp"
#include "message_of.hpp"
#include "solvers/factorisation.hpp"

namespace moat {
namespace {

using testing::message_of;

// k_i x_i + x_i^3 = load in every degree of freedom of a chain, solved with the sparse factorisation.
class CubicChain final : public NonlinearSystem {
 public:
  CubicChain(int size, double load) : tangent_{testing::chain_stiffness(size, 3.0, 3.0)}, load_{load} {
    linear_ = tangent_;
  }
  int size() const override { return static_cast<int>(linear_.rows()); }
  bool compute_residual(const Vector& x, Vector& residual) override {
    ++residuals;
    x_ = x;
    scales_.setConstant(size(), load_);
    residual.noalias() = linear_ * x;
    residual.array() += x.array().cube() - load_;
    return true;
  }
  const Vector& residual_scales() const override { return scales_; }
  bool compute_jacobian() override {
    tangent_ = linear_;
    for (int i = 0; i < size(); ++i) testing::entry(tangent_, i, i) += 3.0 * x_[i] * x_[i];
    return factorisation_.factorise(tangent_);
  }
  void solve(Vector& vector) const override { factorisation_.solve(vector); }
  void set_load(double load) { load_ = load; }

  long residuals = 0;

 private:
  SparseMatrix linear_, tangent_;
  Vector x_, scales_;
  Factorisation factorisation_;
  double load_;
};

// x^2 + 1 = 0 beside a harmless first equation: never balanced.
class NoRoot final : public NonlinearSystem {
 public:
  int size() const override { return 2; }
  bool compute_residual(const Vector& x, Vector& residual) override {
    x_ = x;
    residual[0] = x[0];
    residual[1] = x[1] * x[1] + 1.0;
    return true;
  }
  const Vector& residual_scales() const override { return scales_; }
  bool compute_jacobian() override { return true; }
  void solve(Vector& vector) const override { vector[1] /= 2.0 * x_[1]; }

 private:
  Vector x_, scales_ = Vector::Ones(2);
};

// x - 1 = 0 in three unknowns, with one thing that goes wrong. The start of a solve is x = 5.
class Faulty final : public NonlinearSystem {
 public:
  enum class Fault { none, nan_at_start, nan_at_second, false_at_start, false_at_second, singular, nan_direction };
  explicit Faulty(Fault fault) : fault_{fault} {}
  void set(Fault fault) { fault_ = fault; }
  int size() const override { return 3; }
  bool compute_residual(const Vector& x, Vector& residual) override {
    residual = x.array() - 1.0;
    const bool start = x[0] == 5.0;
    if (fault_ == (start ? Fault::nan_at_start : Fault::nan_at_second))
      residual[1] = std::numeric_limits<double>::quiet_NaN();
    return fault_ != (start ? Fault::false_at_start : Fault::false_at_second);
  }
  const Vector& residual_scales() const override { return scales_; }
  bool compute_jacobian() override { return fault_ != Fault::singular; }
  void solve(Vector& vector) const override {
    if (fault_ == Fault::nan_direction) vector[2] = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  Fault fault_;
  Vector scales_ = Vector::Ones(3);
};

TEST(NewtonSolver, ALinearSystemTakesOneIteration) {
  Faulty system{Faulty::Fault::none};
  NewtonSolver solver{system, {}};
  Vector x = Vector::Constant(3, 5.0);
  const NewtonReport report = solver.solve(x);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(x, Vector::Ones(3));
}

TEST(NewtonSolver, AStartThatBalancesStillTakesOneIteration) {
  Faulty system{Faulty::Fault::none};
  NewtonSolver solver{system, {}};
  Vector x = Vector::Ones(3);
  const NewtonReport report = solver.solve(x);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.residual, 0.0);
  EXPECT_EQ(x, Vector::Ones(3));
}

TEST(NewtonSolver, ReportsTheIterationLimitAndTheWorstDegreeOfFreedom) {
  NoRoot system;
  NewtonSolver solver{system, {.max_iterations = 7, .line_search = LineSearch::backtrack}};
  Vector x{{1.0, 3.0}};
  const NewtonReport report = solver.solve(x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 7);
  EXPECT_EQ(report.worst_degree_of_freedom, 1);
  // x is the last iterate and the residual is that of it.
  EXPECT_DOUBLE_EQ(report.residual, x[1] * x[1] + 1.0);
}

TEST(NewtonSolver, FailuresAreReportedNotThrownAndNotPrinted) {
  using enum Faulty::Fault;
  for (const auto fault : {nan_at_start, nan_at_second, false_at_start, false_at_second, singular, nan_direction}) {
    Faulty system{fault};
    NewtonSolver solver{system, {}};
    Vector x = Vector::Constant(3, 5.0);
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    NewtonReport report;
    EXPECT_NO_THROW(report = solver.solve(x)) << static_cast<int>(fault);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "") << static_cast<int>(fault);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << static_cast<int>(fault);
    EXPECT_FALSE(report.converged) << static_cast<int>(fault);
    // A residual that is not a number is not a small one.
    EXPECT_FALSE(report.residual <= 1e-10) << static_cast<int>(fault);

    // The solver is as good as new afterwards.
    system.set(none);
    x = Vector::Constant(3, 5.0);
    EXPECT_TRUE(solver.solve(x).converged) << static_cast<int>(fault);
    EXPECT_EQ(x, Vector::Ones(3)) << static_cast<int>(fault);
  }
}

// atan x = 0: from |x| > 1.39 full Newton steps jump farther and farther to both sides.
class Arctangent final : public NonlinearSystem {
 public:
  int size() const override { return 1; }
  bool compute_residual(const Vector& x, Vector& residual) override {
    x_ = x;
    residual[0] = std::atan(x[0]);
    return true;
  }
  const Vector& residual_scales() const override { return scales_; }
  bool compute_jacobian() override { return true; }
  void solve(Vector& vector) const override { vector[0] *= 1.0 + x_[0] * x_[0]; }

 private:
  Vector x_, scales_ = Vector::Ones(1);
};

TEST(NewtonSolver, BacktracksWhereFullStepsDiverge) {
  for (const LineSearch line_search : {LineSearch::full_step, LineSearch::backtrack}) {
    Arctangent system;
    NewtonSolver solver{system, {.tolerance = 1e-14, .line_search = line_search}};
    Vector x{{20.0}};
    const NewtonReport report = solver.solve(x);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(std::abs(x[0]), 1e-14);
    // The iterations of a first attempt with full steps, which diverges, are counted too.
    if (line_search == LineSearch::backtrack)
      EXPECT_LE(report.iterations, 20);
    else
      EXPECT_GT(report.iterations, 1);
    // The next solve begins with full steps again.
    x[0] = 0.5;
    EXPECT_LE(solver.solve(x).iterations, 5);
  }
}

TEST(NewtonSolver, SolvesAgainWithoutAllocating) {
  CubicChain system{50, 10.0};
  NewtonSolver solver{system, {.max_iterations = 60}};
  Vector x = Vector::Zero(50);
  ASSERT_TRUE(solver.solve(x).converged);
  const long before = testing::count_of_allocations();
  bool converged = true;
  for (int i = 1; i <= 100; ++i) {
    system.set_load(10.0 + i);
    converged = converged && solver.solve(x).converged;
  }
  EXPECT_EQ(testing::count_of_allocations(), before);
  EXPECT_TRUE(converged);
}

TEST(NewtonSolver, CountsItsOwnAllocations) {
  // The counter of the test above is alive: making a solver allocates.
  CubicChain system{50, 10.0};
  const long before = testing::count_of_allocations();
  if (before == 0) GTEST_SKIP() << "a sanitizer has a malloc of its own";
  const NewtonSolver solver{system, {}};
  EXPECT_GT(testing::count_of_allocations(), before);
}

TEST(NewtonSolver, RefusesOptionsOutOfRange) {
  Faulty system{Faulty::Fault::none};
  EXPECT_EQ(message_of([&] { NewtonSolver(system, {.tolerance = 0.0}); }),
            "NewtonOptions: tolerance = 0 is not allowed; it must be > 0 and < 1. 1e-10 is the default.");
  EXPECT_EQ(message_of([&] { NewtonSolver(system, {.max_iterations = 0}); }),
            "NewtonOptions: max_iterations = 0 is not allowed; it must be >= 1. Give a number in this range.");
}

}  // namespace
}  // namespace moat
