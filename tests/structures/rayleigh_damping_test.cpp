#include "moat.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <vector>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(RayleighFactors, GiveTheRatioAtBothFrequencies) {
  const double ratio = 0.05, first = 12.7, second = 37.2;
  const RayleighFactors factors = rayleigh_factors(ratio, first, second);
  for (const double w : {first, second})
    EXPECT_NEAR(0.5 * (factors.mass_factor / w + factors.stiffness_factor * w), ratio, 1e-15);
  // The order of the frequencies does not matter.
  const RayleighFactors swapped = rayleigh_factors(ratio, second, first);
  EXPECT_DOUBLE_EQ(swapped.mass_factor, factors.mass_factor);
  EXPECT_DOUBLE_EQ(swapped.stiffness_factor, factors.stiffness_factor);
}

TEST(RayleighFactors, OfAChainUseItsOwnFirstTwoModes) {
  const std::vector<Mass> masses{300 * tonne, 250 * tonne, 200 * tonne};
  const std::vector<Stiffness> stiffnesses{200 * MN / m, 150 * MN / m, 120 * MN / m};
  Eigen::Matrix3d stiffness{{350e6, -150e6, 0.0}, {-150e6, 270e6, -120e6}, {0.0, -120e6, 120e6}};
  const Eigen::Matrix3d mass = Eigen::Vector3d{300e3, 250e3, 200e3}.asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> modes{stiffness, mass};
  const RayleighFactors factors = rayleigh_factors_of_chain(0.03, masses, stiffnesses);
  for (int i = 0; i < 2; ++i) {
    const double w = std::sqrt(modes.eigenvalues()[i]);
    EXPECT_NEAR(0.5 * (factors.mass_factor / w + factors.stiffness_factor * w), 0.03, 1e-12);
  }
}

TEST(RayleighFactors, OneStoreyHasTheStiffnessPartOnly) {
  const RayleighFactors factors =
      rayleigh_factors_of_chain(0.05, std::vector<Mass>{4 * kg}, std::vector<Stiffness>{100 * N / m});
  EXPECT_EQ(factors.mass_factor, 0.0);
  EXPECT_DOUBLE_EQ(factors.stiffness_factor, 2.0 * 0.05 / 5.0);
}

TEST(RayleighFactors, WithoutRatioThereIsNoDamping) {
  const RayleighFactors factors = rayleigh_factors(0.0, 1.0, 2.0);
  EXPECT_EQ(factors.mass_factor, 0.0);
  EXPECT_EQ(factors.stiffness_factor, 0.0);
}

TEST(RayleighFactors, RefuseBadInput) {
  EXPECT_EQ(message_of([] { rayleigh_factors(-0.1, 1.0, 2.0); }),
            "RayleighDamping: ratio = -0.1 is not allowed; it must be >= 0 and < 1. 5 % of critical is 0.05.");
  EXPECT_EQ(message_of([] { rayleigh_factors(5.0, 1.0, 2.0); }),
            "RayleighDamping: ratio = 5 is not allowed; it must be >= 0 and < 1. 5 % of critical is 0.05.");
  EXPECT_NE(message_of([] { rayleigh_factors(std::numeric_limits<double>::quiet_NaN(), 1.0, 2.0); }),
            "nothing was thrown");
  EXPECT_EQ(message_of([] { rayleigh_factors(0.05, 0.0, 2.0); }),
            "RayleighDamping: first angular frequency = 0 1/s is not allowed; it must be > 0 1/s and finite.");
  EXPECT_EQ(message_of([] { rayleigh_factors(0.05, 1.0, -2.0); }),
            "RayleighDamping: second angular frequency = -2 1/s is not allowed; it must be > 0 1/s and finite.");
  EXPECT_EQ(message_of([] { rayleigh_factors_of_chain(0.05, {}, {}); }),
            "RayleighDamping: a chain needs at least one storey and one stiffness per mass.");
  EXPECT_EQ(message_of([] {
              rayleigh_factors_of_chain(0.05, std::vector<Mass>{1 * kg, 1 * kg}, std::vector<Stiffness>{1 * N / m});
            }),
            "RayleighDamping: a chain needs at least one storey and one stiffness per mass.");
}

}  // namespace
}  // namespace moat
