// Torsion of isolated buildings, beside the formula of the code.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "message_of.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(Torsion, AmplificationIsThatOfTheCode) {
  // y = 10 m, e = 5 % of 20 m, P_T = sqrt(3).
  const double r = std::sqrt(544.0 / 12.0);
  const double ratio =
      torsional_period_ratio({{10 * m, 6 * m}, {-10 * m, 6 * m}, {10 * m, -6 * m}, {-10 * m, -6 * m}}, r * m);
  EXPECT_NEAR(ratio, 1.732051, 1e-6);
  const TorsionalAmplification amplification = torsional_amplification(10 * m, 1 * m, 20 * m, 12 * m, ratio);
  EXPECT_NEAR(amplification.of_formula, 1.073529, 1e-6);
  EXPECT_EQ(amplification.of_code, 1.15);
  EXPECT_EQ(torsional_period_ratio({{}}, r * m), 1.0);
  EXPECT_EQ(
      message_of([&] { (void)torsional_amplification(1 * m, 1 * m, 1 * m, 1 * m, 0.5); }),
      "torsional_amplification: period_ratio = 0.5 is not allowed; it must be >= 1. Give a number in this range.");
}

PlanBuilding building() {
  PlanBuilding building = testing::small_plan_building(
      2, {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  building.outline = rectangle(20 * m, 12 * m, {3 * m, -2 * m});
  return building;
}

TEST(Torsion, OfARunStandsBesideTheFormula) {
  const GroundMotion first = near_fault_pulse({.quiet_after = 2 * s}).scaled_to_pga(0.3 * g);
  const PlanMotion motion{first, first.scaled_by(0.7)};
  for (const bool eccentric : {false, true}) {
    Model model;
    add(model, eccentric ? with_eccentricity(building(), 0.05, 0.0) : building());
    const CaseResult result = run_case(model, motion, {.error_bars = ErrorBarMode::never});
    ASSERT_EQ(result.torsion.size(), 1U);
    const BuildingTorsion& torsion = result.torsion[0];
    EXPECT_EQ(torsion.where, "base");
    EXPECT_NEAR(torsion.eccentricity, eccentric ? 1.0 : 0.0, 1e-9);
    EXPECT_NEAR(torsion.period_ratio, 1.732051, 1e-6);
    EXPECT_NEAR(torsion.of_formula, eccentric ? 1.073529 : 1.0, 1e-6);
    EXPECT_EQ(torsion.of_code, 1.15);
    EXPECT_GT(torsion.centre, 0.05);
    if (eccentric)
      EXPECT_GT(torsion.amplification(), 1.01);
    else
      EXPECT_NEAR(torsion.amplification(), 1.0, 1e-9);
  }
}

TEST(Torsion, BearingsCountWithTheirStiffness) {
  // Two of three parts of the stiffness at x = 10 m: the centre of rigidity is at 10/3 m.
  PlanBuilding uneven = building();
  uneven.outline = rectangle(20 * m, 12 * m);
  const auto bearing = [](double factor) {
    return LeadRubberBearing{
        .yield_force = factor * 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = factor * 1.6 * MN / m};
  };
  uneven.bearings = PlanBearings{{{{10 * m, 6 * m}, bearing(2.0)},
                                  {{10 * m, -6 * m}, bearing(2.0)},
                                  {{-10 * m, 6 * m}, bearing(1.0)},
                                  {{-10 * m, -6 * m}, bearing(1.0)}}};
  Model model;
  add(model, uneven);
  const auto torsion = torsion_of(model, {});
  ASSERT_EQ(torsion.size(), 1U);
  EXPECT_NEAR(torsion[0].eccentricity, 10.0 / 3.0, 1e-12);
  // y = 10 + 10/3 m, P_T^2 = (mean x^2 + mean y^2)/r_I^2 about the centre of rigidity.
  const double centre = 10.0 / 3.0, squares = 100.0 + centre * centre + 36.0, r_squared = 544.0 / 12.0;
  EXPECT_NEAR(torsion[0].of_formula, 1.0 + (10.0 + centre) * r_squared / squares * 12.0 * centre / 544.0, 1e-12);
  EXPECT_TRUE(std::isnan(torsion[0].amplification()));
}

}  // namespace
}  // namespace moat
