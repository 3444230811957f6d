// Checks of bearings in the result of a run.

#include <gtest/gtest.h>

#include <cmath>

#include "moat.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;

TEST(ChecksOfBearings, AreInTheResultOfARunThatAsksForThem) {
  Model model;
  add(model,
      ShearBuilding{.storeys = 1,
                    .floor_mass = 500 * tonne,
                    .storey_stiffness = 1 * GN / m,
                    .base_mass = 550 * tonne,
                    .isolation = LeadRubberBearing{
                        .yield_force = 1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 8 * MN / m}});
  const GroundMotion motion = near_fault_pulse({}).scaled_to_pga(0.3 * g);
  EXPECT_TRUE(run_case(model, motion).bearing_checks.empty());
  BearingCheckRecorder checks{CheckRules::aashto, {{"bearings", {.displacement_capacity = 0.5 * m}}}};
  CaseRun run{model, motion, {.error_bars = ErrorBarMode::never}};
  run.attach(checks);
  run.run();
  const CaseResult result = run.result();
  ASSERT_EQ(result.bearing_checks.size(), 1U);
  const auto& [bearing, type, demand] = result.bearing_checks.front();
  EXPECT_EQ(bearing, "bearings");
  // Ends of steps miss the peak over continuous time by less than a step's curve.
  const Peak peak = testing::peak_in(result, "isolator_deformation", "bearings");
  EXPECT_LE(demand.demand, std::abs(peak.value));
  EXPECT_NEAR(demand.demand, std::abs(peak.value), 1e-3 * std::abs(peak.value));
  EXPECT_NEAR(demand.time, peak.time, run.transient().statistics().longest_step);
  EXPECT_EQ(demand.ratio(), demand.demand / 0.5);
}

}  // namespace
}  // namespace moat
