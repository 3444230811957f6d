#include "materials/contact/restitution_formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

TEST(DampingFactorOfViscousHertz, IsTheRootOfItsEquation) {
  // z of ln((1 + z)/(1 - z e)) = z (1 + e), to all digits that are printed.
  const double expected[][2] = {{0.9, .16648}, {0.8, .37315},  {0.7, .63483},  {0.65, .79310},
                                {0.6, .97487}, {0.5, 1.43275}, {0.4, 2.08250}, {0.3, 3.08708}};
  for (const auto& [e, z] : expected) EXPECT_NEAR(damping_factor_of_viscous_hertz(e), z, 6e-6) << e;
  for (double e = 0.06; e < 0.95; e += 0.01) {
    const double z = damping_factor_of_viscous_hertz(e);
    EXPECT_NEAR(std::exp(-z * (1.0 + e)) * (1.0 + z), 1.0 - z * e, 1e-14) << e;
    EXPECT_GT(z, 0.0);
  }
}

TEST(DampingFactorOfViscousHertz, TendsToItsAsymptotesAtBothEnds) {
  EXPECT_EQ(damping_factor_of_viscous_hertz(1.0), 0.0);
  // z = 3/4 (1 - e^2) to first order in 1 - e; the next term is of second order.
  for (const double missing : {1e-3, 1e-5, 1e-7, 1e-10, 1e-13}) {
    const double e = 1.0 - missing, first = 1.5 * (1.0 - e);
    EXPECT_NEAR(damping_factor_of_viscous_hertz(e), first, 2.0 * missing * first) << missing;
  }
  // z = 1/e up to exp(-1/e).
  for (const double e : {0.02, 0.01, 1e-3, 1e-6}) EXPECT_NEAR(damping_factor_of_viscous_hertz(e) * e, 1.0, 1e-15);
}

TEST(RestitutionOfViscousHertz, IsTheInverse) {
  for (const double e : {1e-3, 0.01, 0.02, 0.1, 0.3, 0.65, 0.899, 0.901, 0.99, 0.9999, 1.0})
    EXPECT_NEAR(restitution_of_viscous_hertz(damping_factor_of_viscous_hertz(e)), e, 1e-11 * e) << e;
}

TEST(RestitutionOfClampedContact, IsSmoothThroughCriticalDamping) {
  EXPECT_NEAR(restitution_of_clamped_contact(1.0), std::exp(-2.0), 1e-15);
  // a cot a = 1 + (2/3) (x - 1) + ..., the same from both sides.
  for (const double away : {1e-4, 1e-8, 1e-12, 1e-15})
    for (const double x : {1.0 - away, 1.0 + away})
      EXPECT_NEAR(restitution_of_clamped_contact(x), std::exp(-2.0) * (1.0 - 4.0 / 3.0 * (x - 1.0)),
                  2.0 * away * away + 1e-15);
  EXPECT_NEAR(restitution_of_clamped_contact(1e3) * 4e6, 1.0, 1e-4);
}

TEST(DampingRatioOfClampedContact, IsTheInverseOnBothSidesOfCriticalDamping) {
  EXPECT_EQ(damping_ratio_of_clamped_contact(1.0), 0.0);
  for (const double e : {1e-6, 1e-3, 0.01, 0.02, 0.1, 0.135, 0.1354, 0.3, 0.65, 0.9, 0.999, 1.0 - 1e-12})
    EXPECT_NEAR(restitution_of_clamped_contact(damping_ratio_of_clamped_contact(e)), e, 1e-13 * e) << e;
  EXPECT_GT(damping_ratio_of_clamped_contact(0.135), 1.0);
  EXPECT_LT(damping_ratio_of_clamped_contact(0.136), 1.0);
}

TEST(ElasticHertzDuration, AgreesWithEulersIntegral) {
  // 2 * integral of du / sqrt(1 - u^2.5) over (0, 1) = (4/5) B(2/5, 1/2), times the largest indentation over v0.
  const double beta = std::tgamma(0.4) * std::tgamma(0.5) / std::tgamma(0.9);
  const double deepest = std::pow(1.25 * 570.0 * 0.25 / 2e9, 0.4);
  EXPECT_NEAR(elastic_hertz_duration(2e9, 570.0, 0.5), 0.8 * beta * deepest / 0.5, 1e-8 * deepest / 0.5);
}

}  // namespace
}  // namespace moat
