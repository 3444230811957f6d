#include "moat.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(RayleighFactors, OneStoreyHasTheStiffnessPartOnly) {
  const RayleighFactors factors =
      rayleigh_factors_of_chain(0.05, std::vector<Mass>{4 * kg}, std::vector<Stiffness>{100 * N / m});
  EXPECT_EQ(factors.mass_factor, 0.0);
  EXPECT_DOUBLE_EQ(factors.stiffness_factor, 2.0 * 0.05 / 5.0);
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
