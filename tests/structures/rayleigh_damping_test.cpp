#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
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
            "RayleighDamping: first angular frequency = 0 1/s is not allowed; it must be > 0 1/s and finite. Check its "
            "sign and its unit.");
  EXPECT_EQ(message_of([] { rayleigh_factors(0.05, 1.0, -2.0); }),
            "RayleighDamping: second angular frequency = -2 1/s is not allowed; it must be > 0 1/s and finite. Check "
            "its sign and its unit.");
  EXPECT_EQ(message_of([] { rayleigh_factors_of_chain(0.05, {}, {}); }),
            "RayleighDamping: a chain needs at least one storey and one stiffness per mass.");
  EXPECT_EQ(message_of([] {
              rayleigh_factors_of_chain(0.05, std::vector<Mass>{1 * kg, 1 * kg}, std::vector<Stiffness>{1 * N / m});
            }),
            "RayleighDamping: a chain needs at least one storey and one stiffness per mass.");
}

// The ratio of a mode of angular frequency w is a0/(2 w) + a1 w/2.
TEST(RayleighDamping, OfTwoPeriodsHasItsRatiosThere) {
  const auto ratio = [](const RayleighFactors& factors, double period) {
    const double w = 2.0 * std::numbers::pi / period;
    return 0.5 * (factors.mass_factor / w + factors.stiffness_factor * w);
  };
  const RayleighFactors one = given_factors({.ratio = 0.05, .periods = {0.9 * s, 0.2 * s}}).value();
  EXPECT_NEAR(ratio(one, 0.9), 0.05, 1e-15);
  EXPECT_NEAR(ratio(one, 0.2), 0.05, 1e-15);
  const RayleighFactors two = given_factors({.ratios = {0.05, 0.03}, .periods = {0.9 * s, 0.2 * s}}).value();
  EXPECT_NEAR(ratio(two, 0.9), 0.05, 1e-15);
  EXPECT_NEAR(ratio(two, 0.2), 0.03, 1e-15);
  const RayleighFactors exchanged = given_factors({.ratios = {0.03, 0.05}, .periods = {0.2 * s, 0.9 * s}}).value();
  EXPECT_NEAR(exchanged.mass_factor, two.mass_factor, 1e-15);
  EXPECT_NEAR(exchanged.stiffness_factor, two.stiffness_factor, 1e-15);
  const RayleighFactors given = given_factors({.a0 = 0.3 / s, .a1 = 2 * ms}).value();
  EXPECT_EQ(given.mass_factor, 0.3);
  EXPECT_EQ(given.stiffness_factor, 0.002);
  EXPECT_FALSE(given_factors({.ratio = 0.05}).has_value()) << "the modes are those of a building";
}

TEST(RayleighDamping, RefusesBadInput) {
  const auto refusal = [](const RayleighDamping& damping) { return message_of([&] { given_factors(damping); }); };
  EXPECT_EQ(refusal({.ratio = 0.05, .periods = {0.5 * s, 0.5 * s}}),
            "RayleighDamping: both periods are 0.5 s. Give two different ones, usually those of the first two modes.");
  EXPECT_EQ(
      refusal({.ratio = 0.05, .periods = {0.5 * s}}),
      "RayleighDamping: periods[1] = 0 s is not allowed; it must be > 0 s and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal({.ratios = {0.05, 5.0}, .periods = {0.5 * s, 0.1 * s}}),
            "RayleighDamping: ratios[1] = 5 is not allowed; it must be >= 0 and < 1. 5 % of critical is 0.05.");
  EXPECT_EQ(
      refusal({.a0 = -0.3 / s}),
      "RayleighDamping: a0 = -0.3 1/s is not allowed; it must be >= 0 1/s and finite. Check its sign and its unit.");
  EXPECT_EQ(
      refusal({.a1 = -1 * ms}),
      "RayleighDamping: a1 = -0.001 s is not allowed; it must be >= 0 s and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal({.ratio = 0.05, .a1 = 1 * ms}),
            "RayleighDamping: a0 or a1 is given together with ratios or periods. Give a0 and a1 alone.");
  EXPECT_EQ(
      refusal({.ratios = {0.05, 0.03}}),
      "RayleighDamping: ratios are given without periods, or together with ratio. Give .ratios = {0.05, 0.03} with "
      ".periods = {T1, T2}, or one .ratio.");
  // a0/(2 w) + a1 w/2 vanishes at w = sqrt(-a0/a1): with w = 2 pi and 20 pi, ratios 10 % and 0.5 %, a1 = 0 at 1 %.
  const std::string short_periods = refusal({.ratios = {0.1, 0.005}, .periods = {1 * s, 0.1 * s}});
  const double period = std::sqrt((0.1 - 0.05) / (1.0 - 0.005) / 10.0);
  EXPECT_EQ(short_periods,
            "RayleighDamping: these ratios at these periods mean negative damping between the periods 0 "
            "and " +
                to_text(period) + " s. Give a larger ratio at the shorter period.");
  EXPECT_EQ(refusal({.ratios = {0.005, 0.1}, .periods = {1 * s, 0.1 * s}})
                .find("RayleighDamping: these ratios at these periods mean negative damping of all periods above "),
            0U);
}

// The chain of a building and the same building with the factors of that chain move alike.
TEST(RayleighDamping, OfABuildingMayBeGivenByItsFactors) {
  const auto peak = [](const RayleighDamping& damping) {
    Model model;
    add(model,
        ShearBuilding{.storeys = 3, .floor_mass = 500 * tonne, .storey_stiffness = 1 * GN / m, .damping = damping});
    return run_case(model, near_fault_pulse({}), {.transient = {.step = 5 * ms}}).peaks.front().value;
  };
  const RayleighFactors factors =
      rayleigh_factors_of_chain(0.05, std::vector<Mass>(3, 500 * tonne), std::vector<Stiffness>(3, 1 * GN / m));
  EXPECT_EQ(peak({.a0 = factors.mass_factor / s, .a1 = factors.stiffness_factor * s}), peak({.ratio = 0.05}));
  EXPECT_NE(peak({.a1 = factors.stiffness_factor * s}), peak({.ratio = 0.05}));
}

}  // namespace
}  // namespace moat
