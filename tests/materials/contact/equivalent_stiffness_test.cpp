// A linear spring in place of a Hertz spring, and both in series, for 550 t at 1 m/s.
#include "materials/contact/equivalent_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/impact/bilinear_impact.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Approach approach{.mass = 550 * tonne, .speed = 1 * m / s};
constexpr HertzStiffness hertz{1e10};

TEST(EquivalentStiffness, AgreesInForceDurationOrIndentation) {
  const double force = linear_stiffness(hertz, approach, Equal::force).si(),
               duration = linear_stiffness(hertz, approach, Equal::duration).si(),
               indentation = linear_stiffness(hertz, approach, Equal::indentation).si();
  EXPECT_NEAR(force / 1.838080609e9, 1.0, 1e-9);
  EXPECT_NEAR(duration / 1.340239876e9, 1.0, 1e-8);  // 2.94327518 has nine digits
  EXPECT_NEAR(indentation / 1.176371590e9, 1.0, 1e-9);
  // Free impact on the Hertz spring: 21.6226581 mm, 31.7953508 MN, 63.641433 ms.
  EXPECT_NEAR(std::sqrt(force * 550e3) / 31.7953508e6, 1.0, 1e-8);
  EXPECT_NEAR(pi * std::sqrt(550e3 / duration) / 63.641433e-3, 1.0, 1e-7);
  EXPECT_NEAR(std::sqrt(550e3 / indentation) / 21.6226581e-3, 1.0, 1e-8);
  EXPECT_NEAR(duration_of_free_impact(hertz, approach) / (63.641433 * ms), 1.0, 1e-7);
}

TEST(EquivalentStiffness, IsItsOwnInverse) {
  for (const Equal equal : {Equal::force, Equal::duration, Equal::indentation})
    for (const double speed : {0.01, 1.0, 3.0}) {
      const Approach here{.mass = 550 * tonne, .speed = speed * m / s};
      EXPECT_NEAR(hertz_stiffness(linear_stiffness(hertz, here, equal), here, equal) / hertz, 1.0, 1e-14);
    }
}

TEST(EquivalentStiffness, InSeriesHasTheForceOfBothSprings) {
  struct Row {
    double local, behind, force, local_indentation, behind_indentation, equivalent;
  };
  for (const Row& row :
       {Row{1e10, 4.5e10, 31.0464972e6, 21.2818024e-3, 0.68992216e-3, 9.42155238e9},
        Row{2.245354575e10, 1.4208333333e9, 22.7968994e6, 10.1016868e-3, 16.0447385e-3, 4.35291715e9}}) {
    const HertzStiffness both = in_series(HertzStiffness{row.local}, Stiffness{row.behind}, approach);
    EXPECT_NEAR(both.si() / row.equivalent, 1.0, 1e-8);
    // The force of this spring indents the local one and the one behind it, and their energy is that of the approach.
    const double force = std::pow(both.si(), 0.4) * std::pow(1.25 * 550e3, 0.6);
    EXPECT_NEAR(force / row.force, 1.0, 1e-8);
    const double local = std::pow(force / row.local, 2.0 / 3.0), behind = force / row.behind;
    EXPECT_NEAR(local / row.local_indentation, 1.0, 1e-7);
    EXPECT_NEAR(behind / row.behind_indentation, 1.0, 1e-7);
    EXPECT_NEAR((0.4 * force * local + 0.5 * force * behind) / (0.5 * 550e3), 1.0, 1e-12);
  }
  // A rigid body behind it changes nothing.
  EXPECT_NEAR(in_series(hertz, Stiffness{1e30}, approach) / hertz, 1.0, 1e-12);
}

TEST(EquivalentStiffness, OfABilinearTrussOfPractice) {
  const BilinearImpact law = BilinearImpact::from_stiffnesses(1116 * MN / m, 384 * MN / m, 2.54 * mm);
  EXPECT_NEAR(law.stiffness.si() / 2.868727942e9, 1.0, 1e-9);
  EXPECT_NEAR(law.stiffness.si() * std::sqrt(25.4e-3) / 457.2e6, 1.0, 1e-9);
}

TEST(EquivalentStiffness, RefusesBadInputByName) {
  const Approach still{.mass = 550 * tonne, .speed = 0 * m / s};
  const std::string advice =
      "speed = 0 m/s is not allowed; it must be > 0 m/s and finite. The equivalent of a Hertz stiffness depends on the "
      "speed; take that of the table of impacts.";
  EXPECT_EQ(message_of([&] { linear_stiffness(hertz, still); }), "linear_stiffness: " + advice);
  EXPECT_EQ(message_of([&] { hertz_stiffness(1 * GN / m, still); }), "hertz_stiffness: " + advice);
  EXPECT_EQ(message_of([&] { in_series(hertz, 1 * GN / m, still); }), "in_series: " + advice);
  EXPECT_EQ(message_of([&] { duration_of_free_impact(hertz, still); }), "duration_of_free_impact: " + advice);
  EXPECT_EQ(message_of([&] { linear_stiffness({}, approach); }),
            "linear_stiffness: stiffness = 0 N/m^1.5 is not allowed; it must be > 0 N/m^1.5 and finite. Check its sign "
            "and its unit.");
  EXPECT_EQ(
      message_of([&] { in_series({}, 1 * GN / m, approach); }),
      "in_series: local = 0 N/m^1.5 is not allowed; it must be > 0 N/m^1.5 and finite. Check its sign and its unit.");
  EXPECT_EQ(message_of([&] { in_series(hertz, {}, approach); }),
            "in_series: behind = 0 N/m is not allowed; it must be > 0 N/m and finite. Check its sign and its unit.");
  EXPECT_EQ(message_of([&] { linear_stiffness(hertz, {.mass = 0 * kg, .speed = 1 * m / s}); }),
            "linear_stiffness: mass = 0 kg is not allowed; it must be > 0 kg and finite. Check its sign and its unit.");
}

}  // namespace
}  // namespace moat::testing
