#include "materials/bearings/rubber_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/units.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

RubberBearing round_bearing() {
  return {.diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 0.18 * m, .shear_modulus = 0.5 * MPa};
}

RubberBearing rectangular_bearing(Length width_x, Length width_y) {
  return {.width_x = width_x,
          .width_y = width_y,
          .layer_thickness = 6 * mm,
          .rubber_thickness = 0.18 * m,
          .shear_modulus = 0.5 * MPa};
}

TEST(OverlapOfARubberBearing, IsThatOfTwoCirclesOrRectangles) {
  const RubberBearing round = round_bearing();
  EXPECT_EQ(round.overlap(0 * m), 1.0);
  EXPECT_NEAR(round.overlap(0.1 * m), 0.818729222, 1e-9);
  EXPECT_NEAR(round.overlap(0.21 * m, 0.28 * m), 0.391002219, 1e-9) << "0.35 m in any direction";
  EXPECT_NEAR(round.overlap(-0.49 * m), 0.188120404, 1e-9);
  EXPECT_EQ(round.overlap(0.8 * m), 0.0);
  const RubberBearing rectangular = rectangular_bearing(0.6 * m, 0.8 * m);
  EXPECT_NEAR(rectangular.overlap(-0.15 * m, 0.2 * m), 0.5625, 1e-15);
  EXPECT_EQ(rectangular.overlap(0.7 * m), 0.0);
}

TEST(CriticalLoad, IsThatOfAShortColumnThatLosesItsOverlap) {
  const RubberBearing bearing = round_bearing();
  EXPECT_NEAR(bearing.shape_factor(), 0.7 / (4 * 0.006), 1e-12);
  EXPECT_NEAR(bearing.critical_load() / MN, 24.2422641, 1e-7);
  EXPECT_NEAR(bearing.critical_load() / MN, 0.218090 * 0.5 * 0.7 * 0.7 * 0.7 * 0.7 / (0.006 * 0.18), 1e-4);
  EXPECT_NEAR(bearing.critical_load(0.35 * m) / MN, 9.4787791, 1e-7);
  EXPECT_NEAR(bearing.critical_load(0.49 * m) / bearing.critical_load(), 0.2, 1e-15);
  EXPECT_NEAR(bearing.buckling_load_en_15129() / MN, 24.0082765, 1e-7);
  const double square = 0.339583 * 0.5 * 0.6 * 0.6 * 0.6 * 0.6 / (0.006 * 0.18);
  EXPECT_NEAR(rectangular_bearing(0.6 * m, 0.6 * m).critical_load() / MN, square, 1e-4);
  // A rectangle buckles across its longer side: S, A and I are by hand.
  const double shape = 0.6 * 0.8 / (2.8 * 0.006), area = 0.6 * 0.8, inertia = 0.8 * 0.6 * 0.6 * 0.6 / 12.0;
  const double expected = std::numbers::pi * 0.5 / 0.18 * std::sqrt(6.73 * shape * shape * inertia / 3.0 * area);
  EXPECT_NEAR(rectangular_bearing(0.8 * m, 0.6 * m).critical_load() / MN, expected, 1e-12 * expected);
  EXPECT_NEAR(rectangular_bearing(0.8 * m, 0.6 * m).buckling_load_en_15129() / MN,
              1.3 * 0.5 * area * 0.6 * shape / 0.18, 1e-12);
}

TEST(VerticalStiffness, FallsWithTheDisplacement) {
  // r_g of a circle is D/4, so that d = D/4 gives 1 + 3/pi^2.
  const RubberBearing bearing = round_bearing();
  const double shape = 0.7 / 0.024, area = std::numbers::pi * 0.49 / 4, at_rest = 6 * 0.5 * shape * shape * area / 0.18;
  EXPECT_NEAR(bearing.vertical_stiffness() / (MN / m), at_rest, 1e-11 * at_rest);
  EXPECT_NEAR(bearing.vertical_stiffness() / bearing.vertical_stiffness(0.14 * m, 0.105 * m),
              1 + 3 / (std::numbers::pi * std::numbers::pi), 1e-14);
  const RubberBearing rectangular = rectangular_bearing(0.6 * m, 0.8 * m);
  EXPECT_NEAR(rectangular.vertical_stiffness() / rectangular.vertical_stiffness(0.6 * m, 0.8 * m),
              1 + 72 / (std::numbers::pi * std::numbers::pi), 1e-14);
}

TEST(StrainsOfRubber, AreThoseOfTheRules) {
  using enum StrainFormula;
  const RubberBearing bearing = round_bearing();
  const double overlap = bearing.overlap(0.35 * m);
  EXPECT_NEAR(bearing.strain_by_shear(0.35 * m), 1.9444444, 1e-7);
  EXPECT_NEAR(bearing.strain_by_compression(mceer, 4 * MN), 0.7127172, 1e-7);
  EXPECT_NEAR(bearing.strain_by_compression(mceer, 4 * MN, overlap), 1.8227958, 1e-7);
  EXPECT_NEAR(bearing.strain_by_compression(en_15129, 4 * MN, overlap), 1.8217250, 1e-7);
  EXPECT_NEAR(bearing.strain_by_compression(en_1337_3, 4 * MN, overlap), 2.7341936, 1e-7);
  EXPECT_EQ(bearing.strain_by_compression(en_15129, -4 * MN), 0.0);
  EXPECT_NEAR(bearing.strain_by_rotation(mceer, 0.003, 0.002), 0.8506944, 1e-7);
  EXPECT_NEAR(bearing.strain_by_rotation(en_15129, 0.005), 1.1342593, 1e-7);
  // b_x^2 theta_x + b_y^2 theta_y = 0.36 * 0.003 + 0.64 * 0.001
  for (const StrainFormula formula : {mceer, en_15129, en_1337_3})
    EXPECT_NEAR(rectangular_bearing(0.6 * m, 0.8 * m).strain_by_rotation(formula, 0.003, 0.001),
                0.5 * 0.00172 / 0.00108, 1e-14);
}

TEST(RubberBearing, RefusesBadGeometry) {
  const auto refusal = [](RubberBearing bearing, auto change) {
    change(bearing);
    return message_of([&] { bearing.check(Check{"RubberBearing", "LRB"}); });
  };
  const RubberBearing round = round_bearing(), square = rectangular_bearing(0.6 * m, 0.6 * m);
  const std::string object = "RubberBearing \"LRB\": ";
  EXPECT_EQ(refusal(round, [](auto&) {}), "nothing was thrown");
  EXPECT_EQ(refusal(square, [](auto& b) { b.width_x = 1.2 * m; }), "nothing was thrown");
  const std::string one_form =
      object + "diameter and widths are both given, or neither. Give diameter, or width_x and width_y.";
  EXPECT_EQ(refusal(round, [](auto& b) { b.diameter = {}; }), one_form);
  EXPECT_EQ(refusal(round, [](auto& b) { b.width_y = 1 * m; }), one_form);
  const auto not_positive = [&](const std::string& value, const std::string& unit) {
    return object + value + " " + unit + " is not allowed; it must be > 0 " + unit +
           " and finite. Check its sign and its unit.";
  };
  EXPECT_EQ(refusal(round, [](auto& b) { b.diameter = -1 * m; }), not_positive("diameter = -1", "m"));
  EXPECT_EQ(refusal(square, [](auto& b) { b.width_x = {}; }), not_positive("width_x = 0", "m"));
  EXPECT_EQ(refusal(square, [](auto& b) { b.width_y = {}; }), not_positive("width_y = 0", "m"));
  EXPECT_EQ(refusal(round, [](auto& b) { b.layer_thickness = 0 * m; }), not_positive("layer_thickness = 0", "m"));
  EXPECT_EQ(refusal(round, [](auto& b) { b.rubber_thickness = -1 * m; }), not_positive("rubber_thickness = -1", "m"));
  EXPECT_EQ(refusal(round, [](auto& b) { b.shear_modulus = 0 * Pa; }), not_positive("shear_modulus = 0", "Pa"));
  EXPECT_EQ(refusal(round, [](auto& b) { b.rubber_thickness = 5 * mm; }),
            object +
                "rubber_thickness = 0.005 m is not allowed; it must be >= layer_thickness. It is the sum of all "
                "layers.");
  EXPECT_EQ(refusal(square, [](auto& b) { b.width_x = 1.5 * m; }),
            object +
                "ratio of widths = 2.5 is not allowed; it must be <= 2. The formulas of the rubber are those of a "
                "square.");
}

}  // namespace
}  // namespace moat::testing
