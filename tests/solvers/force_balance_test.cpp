#include "solvers/force_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace moat {
namespace {

// Rows with these scales and this round-off, the same in all.
class Rows final : public NonlinearSystem {
 public:
  Rows(Vector scales, double round_off) : scales_{std::move(scales)}, round_off_{round_off} {}

  int size() const override { return static_cast<int>(scales_.size()); }
  bool compute_residual(const Vector&, Vector&) override { return false; }
  const Vector& residual_scales() const override { return scales_; }
  double round_off(int) const override { return round_off_; }
  bool compute_jacobian() override { return false; }
  void solve(Vector&) const override {}

 private:
  Vector scales_;
  double round_off_;
};

bool holds(const Vector& residual, const Rows& rows) {
  return ForceBalance{1e-8}.holds(ForceBalance::worst_row(residual, rows), residual, rows);
}

TEST(ForceBalance, FindsTheWorstRowByItsOwnScale) {
  const WorstRow worst = ForceBalance::worst_row(Vector{{1.0, -0.5, 0.1}}, Rows{Vector{{10.0, 2.0, 1.0}}, 0.0});
  EXPECT_EQ(worst.residual, 0.25);
  EXPECT_EQ(worst.degree_of_freedom, 1);
}

TEST(ForceBalance, HoldsWithinTheToleranceOfEveryRow) {
  const Rows rows{Vector{{1e6, 1.0}}, 0.0};
  EXPECT_TRUE(holds(Vector{{0.9e-2, -0.9e-8}}, rows));
  EXPECT_FALSE(holds(Vector{{0.9e-2, -1.1e-8}}, rows));
}

TEST(ForceBalance, PassesRoundOffThatIsSmallBesideItsRow) {
  const Rows rows{Vector{{1.0, 1.0}}, 1e-6};
  EXPECT_TRUE(holds(Vector{{0.0, 0.9e-6}}, rows));
  EXPECT_FALSE(holds(Vector{{0.0, 1.1e-6}}, rows));
  EXPECT_FALSE(holds(Vector{{0.0, 0.9e-6}}, {Vector{{1.0, 1.0}}, 0.8e-6}));
  EXPECT_FALSE(holds(Vector{{0.0, 0.9e-4}}, {Vector{{1.0, 1.0}}, 1.0}));
}

// The second row has no force but round-off.
TEST(ForceBalance, PassesRoundOffThatIsSmallBesideTheLargestForce) {
  EXPECT_TRUE(holds(Vector{{0.0, 1e-9}}, {Vector{{1e3, 1e-9}}, 2e-9}));
  EXPECT_FALSE(holds(Vector{{0.0, 1e-9}}, {Vector{{1e3, 1e-9}}, 0.5e-9}));
  EXPECT_FALSE(holds(Vector{{0.0, 1e-2}}, {Vector{{1e3, 1e-2}}, 1.0}));
}

// Behind the end of a motion all rows may have no other force.
TEST(ForceBalance, PassesRoundOffThatIsSmallBesideTheLargestForceSoFar) {
  const Rows shaken{Vector{{1e3, 1e3}}, 2e-9}, at_rest{Vector{{1e-9, 1e-9}}, 2e-9};
  const Vector balanced{{0.0, 0.0}}, round_off{{0.0, 1e-9}};
  const auto holds = [](ForceBalance& balance, const Vector& residual, const Rows& rows) {
    return balance.holds(ForceBalance::worst_row(residual, rows), residual, rows);
  };
  ForceBalance balance{1e-8};
  EXPECT_FALSE(holds(balance, round_off, at_rest));
  // An iterate that does not balance may have any force.
  EXPECT_FALSE(holds(balance, Vector{{1.0, 1.0}}, shaken));
  EXPECT_FALSE(holds(balance, round_off, at_rest));
  EXPECT_TRUE(holds(balance, balanced, shaken));
  EXPECT_TRUE(holds(balance, round_off, at_rest));
}

TEST(ForceBalance, NamesARowThatIsNoNumber) {
  const Rows rows{Vector{{1.0, 1.0, 1.0}}, 1.0};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    const Vector residual{{0.5, bad, 0.7}};
    const WorstRow worst = ForceBalance::worst_row(residual, rows);
    EXPECT_TRUE(std::isnan(worst.residual));
    EXPECT_EQ(worst.degree_of_freedom, 1);
    EXPECT_FALSE(holds(residual, rows));
  }
}

}  // namespace
}  // namespace moat
