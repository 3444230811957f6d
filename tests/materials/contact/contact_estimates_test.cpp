// Estimates of contact stiffness against hand calculations. Concrete has 30 GPa, 0.2, 2500 kg/m^3.
#include "materials/contact/contact_estimates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "materials/impact/exact_hertz_damp.hpp"
#include "materials/soil/hyperbolic_backfill.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

template <class Q>
void expect_estimate(const Estimate<Q>& estimate, double value, double low, double high) {
  EXPECT_NEAR(estimate.value.si() / value, 1.0, 1e-9);
  EXPECT_NEAR(estimate.low.si() / low, 1.0, 1e-9);
  EXPECT_NEAR(estimate.high.si() / high, 1.0, 1e-9);
  EXPECT_FALSE(estimate.source.empty());
  EXPECT_FALSE(estimate.assumption.empty());
  const Q converted = estimate;
  EXPECT_EQ(converted, estimate.value);
}

const SlabAlongHit slab{.length = 20 * m, .width = 20 * m, .thickness = 50 * cm};

TEST(ContactEstimates, SlabIsThreeTwoOrOneTimesItsAxialStiffness) {
  // E A/L = 30 GPa x 10 m^2/20 m.
  for (const auto& [mass, parts] :
       {std::pair{SlabMass::spread, 3.0}, std::pair{SlabMass::in_middle, 2.0}, std::pair{SlabMass::at_far_end, 1.0}}) {
    SlabAlongHit here = slab;
    here.mass = mass;
    expect_estimate(axial_stiffness_of_slab(here), parts * 1.5e10, 1.5e10, 4.5e10);
  }
}

TEST(ContactEstimates, HitOnAPartOfTheEdgeSpreadsIntoTheSlab) {
  SlabAlongHit here = slab;
  here.contact_width = 1 * m;
  const double spreading = std::log(20.0) / (2.0 * 30e9 * 0.5);
  EXPECT_NEAR(1e-10 / spreading, 1.0014246, 1e-7);
  const double stiffness = axial_stiffness_of_slab(here).value.si();
  EXPECT_NEAR(stiffness / 8.1913523e9, 1.0, 1e-8);
  EXPECT_NEAR(1.0 / stiffness, spreading + 1.0 / 4.5e10, 1e-20);
}

TEST(ContactEstimates, WaveReturnsFromTheFarEnd) {
  const double there_and_home = wave_return_time(slab).si();
  EXPECT_NEAR(there_and_home / 11.54700538e-3, 1.0, 1e-9);
  const double speed = 2.0 * 20.0 / there_and_home;
  EXPECT_NEAR(speed / 3464.101615, 1.0, 1e-9);
  EXPECT_NEAR(2500.0 * speed * 10.0 / 86.60254038e6, 1.0, 1e-9);  // rho c A
}

TEST(ContactEstimates, SlabEdgeIsAQuarterOfSpheres) {
  // E* = 15.625 GPa, R = 3.744938504 m of 550 t and 1.683890301 m of 50 t.
  constexpr double modulus = 15.625e9, r_1 = 3.744938504, r_2 = 1.683890301;
  const double plane = 4.0 / 3.0 * modulus * std::sqrt(r_1),
               pair = 4.0 / 3.0 * modulus * std::sqrt(r_1 * r_2 / (r_1 + r_2));
  EXPECT_NEAR(plane / 4.031634082e10, 1.0, 1e-9);
  EXPECT_NEAR(pair / 2.245354575e10, 1.0, 1e-9);
  expect_estimate(contact_stiffness_of_slab_edge({.mass = 550 * tonne}), plane / 4.0, plane / 10.0, plane);
  // docs/how-to/contact_stiffness_and_restitution.md: the default, and that of Zhao, Liu & Li (2017), 8 to 14 times
  // below.
  const double mean = std::pow(2.95e9 * 2.87e9 * 4.29e9 * 1.26e10 * 2.75e10 * plane * pair, 1.0 / 7.0);
  EXPECT_NEAR(mean / ExactHertzDamp::typical().stiffness.si(), 1.0, 0.05);
  EXPECT_NEAR(pair / 2.95e9, 8.0, 0.5);
  EXPECT_NEAR(plane / 2.95e9, 14.0, 0.5);
  expect_estimate(contact_stiffness_of_slab_edge({.mass = 550 * tonne, .wall_mass = 50 * tonne}), pair / 4.0,
                  pair / 10.0, pair);
  // With h = (1 - nu^2)/(pi E): k = 4/(3 pi (h_1 + h_2)) sqrt(R), also for two materials.
  const Concrete stiff{.youngs_modulus = 40 * GPa, .poissons_ratio = 0.25};
  const double pi = std::numbers::pi, h_1 = 0.96 / (pi * 30e9), h_2 = 0.9375 / (pi * 40e9);
  EXPECT_NEAR(contact_stiffness_of_slab_edge({.mass = 550 * tonne, .wall_material = stiff}).high.si() /
                  (4.0 / (3.0 * pi * (h_1 + h_2)) * std::sqrt(r_1)),
              1.0, 1e-9);
}

TEST(ContactEstimates, VerticalEdgeIsALineOfContact) {
  expect_estimate(contact_stiffness_of_vertical_edge({.thickness = 50 * cm}), 6.135923152e9, 6.135923152e8,
                  6.135923152e9);
}

TEST(ContactEstimates, ColumnIsABeam) {
  ColumnHit column{.height = 3 * m, .depth = 50 * cm, .width = 50 * cm, .cracked_share = 1.0};
  // 192 E I/h^3 and 48 E I/h^3.
  expect_estimate(stiffness_of_column_hit(column), 1.111111111e9, 1.111111111e9 / 4.0, 1.111111111e9);
  column.share = 0.6;
  EXPECT_NEAR(stiffness_of_column_hit(column).value.si() / 1.255867413e9, 1.0, 1e-9);
  column.share = 0.5;
  column.cracked_share = 0.35;
  expect_estimate(stiffness_of_column_hit(column), 3.888888889e8, 3.888888889e8 / 4.0, 1.111111111e9);
  column.count = 4;
  column.clamped = false;
  EXPECT_NEAR(stiffness_of_column_hit(column).value.si() / 3.888888889e8, 1.0, 1e-9);
}

TEST(ContactEstimates, WallResistsOnItsEffectiveWidth) {
  EXPECT_NEAR(effective_wall_width({.contact_width = 1 * m, .height = 2 * m, .width = 20 * m}).si(), 5.4, 1e-14);
  EXPECT_EQ(effective_wall_width({.contact_width = 18 * m, .height = 2 * m, .width = 20 * m}), 20 * m);
}

TEST(ContactEstimates, BackfillGrowsWithTheWall) {
  const HyperbolicBackfill soil = HyperbolicBackfill::behind({.height = 2 * m, .width = 20 * m});
  EXPECT_NEAR(soil.initial_stiffness.si() / 483.3333333e6, 1.0, 1e-9);
  EXPECT_NEAR(soil.ultimate_force.si() / 9.240362812e6, 1.0, 1e-9);
  const HyperbolicBackfill tested = HyperbolicBackfill::behind({.height = 1.68 * m, .width = 10 * m});
  EXPECT_NEAR(tested.initial_stiffness.value() / HyperbolicBackfill::typical().initial_stiffness.value(), 1.0, 1e-14);
  EXPECT_NEAR(tested.ultimate_force.value() / HyperbolicBackfill::typical().ultimate_force.value(), 1.0, 1e-14);
}

TEST(ContactEstimates, RefuseBadInputByName) {
  const auto slab_message = [](auto change) {
    return message_of([&] {
      SlabAlongHit here = slab;
      change(here);
      axial_stiffness_of_slab(here);
    });
  };
  EXPECT_EQ(slab_message([](SlabAlongHit& here) { here.contact_width = 25 * m; }),
            "axial_stiffness_of_slab: contact_width = 25 m is not allowed; it must be > 0 m and <= width = 20 m. Leave "
            "it out for the whole edge.");
  // At 45 degrees the load reaches 1 m + 2 x 5 m.
  EXPECT_EQ(
      slab_message([](SlabAlongHit& here) {
        here.length = 5 * m;
        here.contact_width = 1 * m;
      }),
      "axial_stiffness_of_slab: contact_width = 1 m is not allowed; it must be >= width - 2 length = 10 m. The load "
      "spreads at 45 degrees, and reaches this width alone: give a smaller width.");
  EXPECT_EQ(slab_message([](SlabAlongHit& here) { here.thickness = -1 * m; }),
            "axial_stiffness_of_slab: thickness = -1 m is not allowed; it must be > 0 m and finite. Check its sign and "
            "its unit.");
  EXPECT_EQ(slab_message([](SlabAlongHit& here) { here.length = 0 * m; }),
            "axial_stiffness_of_slab: length = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its "
            "unit.");
  EXPECT_EQ(
      slab_message([](SlabAlongHit& here) { here.width = 0 * m; }),
      "axial_stiffness_of_slab: width = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its unit.");
  EXPECT_EQ(slab_message([](SlabAlongHit& here) { here.material.youngs_modulus = 0 * GPa; }),
            "axial_stiffness_of_slab: youngs_modulus = 0 Pa is not allowed; it must be > 0 Pa and "
            "finite. Check its sign and its unit.");
  EXPECT_EQ(
      slab_message([](SlabAlongHit& here) { here.material.poissons_ratio = 0.5; }),
      "axial_stiffness_of_slab: poissons_ratio = 0.5 is not allowed; it must be >= 0 and < 0.5. Concrete has about "
      "0.2.");
  EXPECT_EQ(message_of([] { wave_return_time({.length = 0 * m, .width = 1 * m, .thickness = 1 * m}); }),
            "wave_return_time: length = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its unit.");
  EXPECT_EQ(message_of([] { contact_stiffness_of_slab_edge({.mass = 0 * kg}); }),
            "contact_stiffness_of_slab_edge: mass = 0 kg is not allowed; it must be > 0 kg and finite. Check its sign "
            "and its unit.");
  EXPECT_EQ(message_of([] { contact_stiffness_of_slab_edge({.mass = 1 * kg, .wall_mass = -1 * kg}); }),
            "contact_stiffness_of_slab_edge: wall_mass = -1 kg is not allowed; it must be >= 0 kg and finite. Leave it "
            "out for a plane wall.");
  EXPECT_EQ(message_of([] { contact_stiffness_of_vertical_edge({.thickness = 0 * m}); }),
            "contact_stiffness_of_vertical_edge: thickness = 0 m is not allowed; it must be > 0 m and finite. Check "
            "its sign and its unit.");
  const auto column_message = [](auto change) {
    return message_of([&] {
      ColumnHit column{.height = 3 * m, .depth = 50 * cm, .width = 50 * cm};
      change(column);
      stiffness_of_column_hit(column);
    });
  };
  EXPECT_EQ(
      column_message([](ColumnHit& column) { column.share = 1.0; }),
      "stiffness_of_column_hit: share = 1 is not allowed; it must be > 0 and < 1. A hit at a floor is a Gap between "
      "nodes.");
  EXPECT_EQ(column_message([](ColumnHit& column) { column.cracked_share = 0.0; }),
            "stiffness_of_column_hit: cracked_share = 0 is not allowed; it must be > 0 and <= 1. 0.3 to 0.5 where "
            "concrete has cracked.");
  EXPECT_EQ(column_message([](ColumnHit& column) { column.count = 0; }),
            "stiffness_of_column_hit: count = 0 is not allowed; it must be >= 1. Give a number in this range.");
  EXPECT_EQ(message_of([] { effective_wall_width({.contact_width = 3 * m, .height = 1 * m, .width = 2 * m}); }),
            "effective_wall_width: contact_width = 3 m is not allowed; it must be > 0 m and <= width = 2 m. Check its "
            "sign and its unit.");
  EXPECT_EQ(message_of([] { HyperbolicBackfill::behind({.height = 0 * m, .width = 2 * m}); }),
            "HyperbolicBackfill::behind: height = 0 m is not allowed; it must be > 0 m and finite. Check its sign and "
            "its unit.");
}

}  // namespace
}  // namespace moat::testing
