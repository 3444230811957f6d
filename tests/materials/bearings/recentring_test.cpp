#include "materials/bearings/recentring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

// A pendulum of R = 2 m with mu = 0.05 under 1 MN.
Backbone pendulum() { return {.strength = 0.05 * MN, .restoring_stiffness = 0.5 * MN / m, .weight = 1 * MN}; }

TEST(LargestStuckDisplacement, IsFrictionTimesRadius) {
  EXPECT_NEAR(pendulum().largest_stuck_displacement() / m, 0.05 * 2.0, 1e-15);
}

TEST(RestoringChecks, AreThoseOfAPendulum) {
  const auto checks = [](Length displacement) { return restoring_checks(pendulum(), displacement); };
  const std::vector<RestoringCheck> at_20_cm = checks(0.2 * m);
  ASSERT_EQ(at_20_cm.size(), 5U);
  EXPECT_NEAR(at_20_cm[0].value, 0.2 / (2 * 2.0), 1e-15);
  EXPECT_NEAR(at_20_cm[1].value, at_20_cm[0].value, 0.0);
  EXPECT_NEAR(at_20_cm[2].value, 2 * std::numbers::pi * std::sqrt(2.0 / 9.80665), 1e-14);
  // E_s = W D^2/(2 R) over E_h = mu W D; D over mu R.
  EXPECT_NEAR(at_20_cm[3].value, 0.5 * 0.2 / (0.05 * 2.0), 1e-15);
  EXPECT_NEAR(at_20_cm[4].value, 0.2 / (0.05 * 2.0), 1e-15);
  for (const RestoringCheck& check : at_20_cm) EXPECT_TRUE(check.is_kept) << check.rule;

  // Both sides of every limit: D/R = 0.05 and 1/40, D = mu R/2 twice, and a period of 6 s, R = 8.94 m.
  const double limits[] = {0.1, 0.05, 0.0, 0.05, 0.05};
  for (const int i : {0, 1, 3, 4}) {
    EXPECT_TRUE(checks(1.0001 * limits[i] * m)[i].is_kept) << i;
    EXPECT_FALSE(checks(0.9999 * limits[i] * m)[i].is_kept) << i;
  }
  Backbone soft = pendulum();
  soft.restoring_stiffness = 1 * MN / (8.94 * m);
  EXPECT_TRUE(restoring_checks(soft, 0.2 * m)[2].is_kept);
  soft.restoring_stiffness = 1 * MN / (8.95 * m);
  EXPECT_FALSE(restoring_checks(soft, 0.2 * m)[2].is_kept);
}

TEST(RestoringChecks, AreKeptWithoutFriction) {
  Backbone without = pendulum();
  without.strength = 0 * N;
  for (const RestoringCheck& check : restoring_checks(without, 0.2 * m)) EXPECT_TRUE(check.is_kept) << check.rule;
}

TEST(AccumulationOfEn1998, IsThatOfItsFormula) {
  EXPECT_NEAR(accumulation_en_1998_2(0.1 * m, 1 * mm, 0.2 * m), 1.0431911, 5e-8);
  EXPECT_NEAR(accumulation_en_1998_2(0.05 * m, 1 * mm, 0.2 * m), 1.1109902, 5e-8);
  EXPECT_EQ(accumulation_en_1998_2(1 * mm, 1 * mm, 0.2 * m), 1.0);
  EXPECT_NEAR(displacement_demand_en_1998_2(0.02 * m, 0.1 * m, 1 * mm, 0.2 * m) / m, 0.02 + 0.12 * 1.0431911, 1e-8);
}

TEST(Recentring, RefusesBadInput) {
  const auto refusal = [](auto change) {
    Backbone backbone = pendulum();
    change(backbone);
    return message_of([&] { (void)restoring_checks(backbone, 0.2 * m); });
  };
  const std::string object = "restoring_checks: ";
  EXPECT_EQ(refusal([](auto& b) { b.strength = -1 * N; }),
            object + "strength = -1 N is not allowed; it must be >= 0 N and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal([](auto& b) { b.restoring_stiffness = 0 * N / m; }),
            object +
                "restoring_stiffness = 0 N/m is not allowed; it must be > 0 N/m and finite. Isolators without one "
                "do not come back.");
  EXPECT_EQ(refusal([](auto& b) { b.weight = 0 * N; }),
            object + "weight = 0 N is not allowed; it must be > 0 N and finite. Check its sign and its unit.");
  EXPECT_EQ(message_of([] { (void)restoring_checks(pendulum(), 0 * m); }),
            object + "displacement = 0 m is not allowed; it must be > 0 m and finite. Give the design displacement.");
  const auto of_rho = [](double d, double d_y, double d_r, double d_0) {
    return message_of([&] { (void)displacement_demand_en_1998_2(d_0 * m, d * m, d_y * m, d_r * m); });
  };
  EXPECT_EQ(of_rho(0.1, 0.0, 0.2, 0.0),
            "accumulation_en_1998_2: yield_displacement = 0 m is not allowed; it must be > 0 m and finite. Check its "
            "sign and its unit.");
  EXPECT_EQ(of_rho(0.1, 0.001, 0.0, 0.0),
            "accumulation_en_1998_2: stuck_displacement = 0 m is not allowed; it must be > 0 m and finite. Check its "
            "sign and its unit.");
  EXPECT_EQ(of_rho(0.1, 0.2, 0.2, 0.0),
            "accumulation_en_1998_2: displacement = 0.1 m is not allowed; it must be >= yield_displacement and "
            "finite. Check its sign and its unit.");
  EXPECT_EQ(of_rho(0.1, 0.001, 0.2, -0.1),
            "displacement_demand_en_1998_2: offset = -0.1 m is not allowed; it must be >= 0 m and finite. Check its "
            "sign and its unit.");
}

}  // namespace
}  // namespace moat::testing
