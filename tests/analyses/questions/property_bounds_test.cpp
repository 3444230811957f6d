#include "moat.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Q = 1.737 MN and k2 = 19.3 MN/m, times the factors; k1 - k2 stays.
Model building(const PropertyFactors& factors) {
  Model model;
  const double strength = 1.737e6 * factors.strength, post_yield = 19.3e6 * factors.stiffness, sliding = 173.7e6;
  const double yield = strength / sliding;
  const Building added =
      add(model, ShearBuilding{.storeys = 2,
                               .floor_mass = 1250 * tonne,
                               .storey_stiffness = 1 * GN / m,
                               .base_mass = 550 * tonne,
                               .isolation = LeadRubberBearing{.yield_force = (strength + post_yield * yield) * N,
                                                              .yield_displacement = yield * m,
                                                              .post_yield_stiffness = post_yield * N / m}});
  add(model, Moat<Hertz>{.around = added.base, .clearance = 60 * cm, .law = {.stiffness = 2.95e9 * N / m_3_2}});
  return model;
}

const PropertyBounds bounds{.lower = {0.7, 0.9}, .upper = {1.5, 1.2}};
const GroundMotion motion = near_fault_pulse({}).scaled_to_pga(0.4 * g);

TEST(PropertyBounds, RunsAllThreeAndEnvelopesTheirPeaks) {
  const BoundedResult result = run_bounds(bounds, building, motion);
  const std::array<PropertyFactors, 3> factors{PropertyFactors{}, bounds.lower, bounds.upper};
  for (std::size_t i = 0; i < 3; ++i) {
    Model alone = building(factors[i]);
    const CaseResult expected = run_case(alone, motion);
    ASSERT_EQ(result.cases[i].peaks.size(), expected.peaks.size());
    for (std::size_t k = 0; k < expected.peaks.size(); ++k)
      EXPECT_EQ(result.cases[i].peaks[k].value, expected.peaks[k].value);
  }
  for (const auto& [peak, of] : result.envelope) {
    bool found = false;
    for (std::size_t i = 0; i < 3; ++i)
      for (const Peak& each : result.cases[i].peaks) {
        if (each.quantity != peak.quantity || each.where != peak.where) continue;
        EXPECT_LE(each.magnitude(), peak.magnitude());
        found = found || (each.value == peak.value && of == BoundedResult::names[i]);
      }
    EXPECT_TRUE(found) << peak.quantity;
  }
  // Which one governs depends on the peak.
  std::set<std::string> governing;
  for (const auto& [peak, of] : result.envelope) governing.insert(of);
  EXPECT_GT(governing.size(), 1U);
  EXPECT_EQ(result.governing("displacement", "base").peak.unit, "m");
  EXPECT_EQ(message_of([&] { static_cast<void>(result.governing("displacement", "roof")); }),
            "BoundedResult: there is no peak displacement at \"roof\".");
}

TEST(PropertyBounds, RefusesFactorsOnTheWrongSide) {
  EXPECT_EQ(
      message_of([&] {
        run_bounds({.lower = {1.1, 0.9}, .upper = {1.5, 1.2}}, building, motion);
      }),
      "PropertyBounds: lower.strength = 1.1 is not allowed; it must be > 0 and <= 1. Give a number in this range.");
  EXPECT_EQ(message_of([&] {
              run_bounds({.lower = {0.9, 0.9}, .upper = {0.5, 1.2}}, building, motion);
            }),
            "PropertyBounds: upper.strength = 0.5 is not allowed; it must be from 1 to 10. The nominal properties lie "
            "between the bounds.");
}

TEST(PropertyBounds, FollowsAsce7) {
  EXPECT_NEAR(PropertyBounds::asce_7_upper({1.2, 1.3, 1.15}), 1.15 * 1.3 * 1.15, 1e-15);
  EXPECT_NEAR(PropertyBounds::asce_7_lower({0.9, 0.9, 0.85}), 0.925 * 0.9 * 0.85, 1e-15);
  EXPECT_EQ(PropertyBounds::asce_7_upper({1.2, 1.3, 1.0}, false), 1.8);
  EXPECT_EQ(PropertyBounds::asce_7_lower({0.9, 0.9, 0.9}, false), 0.6);
}

TEST(EffectiveProperties, AreThoseOfABilinearLoop) {
  const Bilinear law{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
  std::vector<double> deformations, forces;
  LawPath<Bilinear> path{law, 0};
  path.move(0.3, 1.0);
  constexpr int steps = 20000;
  for (int i = 1; i <= 2 * steps; ++i) {
    deformations.push_back(path.deformation());
    forces.push_back(path.force());
    path.move(0.3 * (i < steps ? 1.0 - 2.0 * i / steps : -3.0 + 2.0 * i / steps), 1.0);
  }
  const EffectiveProperties effective = effective_properties(deformations, forces);
  EXPECT_NEAR(effective.stiffness, 25.09e6, 1.0);
  EXPECT_NEAR(effective.damping_ratio, 0.142015, 1e-5);
  EXPECT_NEAR(effective.amplitude, 0.3, 1e-12);
  EXPECT_EQ(message_of([] {
              effective_properties(std::vector{1.0, 1.0, 1.0}, std::vector{0.0, 1.0, 2.0});
            }),
            "EffectiveProperties: the loop has no width. Give the deformations and forces of one full cycle.");
}

}  // namespace
}  // namespace moat::testing
