#include "materials/impact/bilinear_impact.hpp"

#include <gtest/gtest.h>

#include "base/units.hpp"
#include "message_of.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

const BilinearImpact law{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65, .expected_indentation = 2 * cm};

TEST(BilinearImpact, HasTheStiffnessesAndTheLoopOfItsParameters) {
  const BilinearContact contact = law.between(1e5);
  EXPECT_NEAR(contact.loading_stiffness, 1.38091e9, 5e3);
  EXPECT_NEAR(contact.yielding_stiffness, 3.10113e8, 5e2);
  LawPath<BilinearContact> path{contact};
  path.move(0.02, 1.0);
  EXPECT_NEAR(path.force(), 1.38091e9 * 0.002 + 3.10113e8 * 0.018, 2e1);
  path.move(0.0, 1.0);
  EXPECT_NEAR(path.work(), 38548.6, 0.1);
  EXPECT_NEAR(path.dissipated(), 38548.6, 0.1);
}

// ImpactMaterial of OpenSees has K1, K2 and d_y.
TEST(BilinearImpact, OfTwoStiffnessesHasThese) {
  for (const double share : {0.1, 0.05}) {
    const BilinearImpact given = BilinearImpact::from_stiffnesses(900 * MN / m, 300 * MN / m, 2 * mm, share);
    const BilinearContact contact = given.between(1e5);
    EXPECT_NEAR(contact.loading_stiffness, 9e8, 1e-4);
    EXPECT_NEAR(contact.yielding_stiffness, 3e8, 1e-4);
    EXPECT_NEAR(contact.yield_indentation, 0.002, 1e-15);
    EXPECT_NEAR(given.expected_indentation.si(), 0.002 / share, 1e-15);
  }
}

TEST(BilinearImpact, RefusesStiffnessesThatNoParametersHave) {
  const auto refusal = [](Stiffness loading, Stiffness yielding) {
    return message_of([&] { static_cast<void>(BilinearImpact::from_stiffnesses(loading, yielding, 2 * mm)); });
  };
  EXPECT_EQ(refusal(300 * MN / m, 300 * MN / m),
            "BilinearImpact::from_stiffnesses: loading = 3e+08 N/m is not allowed; it must be above yielding. Check "
            "its sign and its unit.");
  EXPECT_EQ(refusal(300 * MN / m, 0 * N / m),
            "BilinearImpact::from_stiffnesses: yielding = 0 N/m is not allowed; it must be > 0 N/m and finite. Check "
            "its sign and its unit.");
  EXPECT_EQ(refusal(10 * GN / m, 1 * GN / m),
            "BilinearImpact::from_stiffnesses: loading = 1e+10 N/m is not allowed; it must be nearer to yielding, or "
            "yield_share smaller. The energy lost to d_y / yield_share exceeds that of the Hertz contact.");
}

// K1 to d_y, K2, K1 down to the line K2 d, along it, K1 up to the upper line again.
TEST(BilinearImpact, UnloadsAndLoadsAgainAlongItsLines) {
  const BilinearContact contact{.loading_stiffness = 10.0, .yielding_stiffness = 2.0, .yield_indentation = 1.0};
  LawPath<BilinearContact> path{contact};
  const auto expect = [&](double indentation, double force) {
    path.move(indentation, 1.0);
    EXPECT_NEAR(path.force(), force, 1e-8) << indentation;
  };
  expect(1.0, 10.0);
  expect(4.0, 16.0);
  expect(3.5, 11.0);
  expect(3.8, 14.0);
  expect(3.0, 6.0);
  expect(2.0, 4.0);
  expect(2.5, 9.0);
  expect(5.0, 18.0);
  expect(0.0, 0.0);
  EXPECT_NEAR(path.work(), path.stored() + path.dissipated(), 1e-8);
  // The next contact starts without memory of this one.
  path.move(-1.0, 1.0);
  expect(1.0, 10.0);
}

}  // namespace
}  // namespace moat::testing
