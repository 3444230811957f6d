#include "output/peaks/drift_ratios.hpp"

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "peak_in.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

TEST(DriftRatios, ArePercentOfTheHeightOfTheStorey) {
  Model model;
  add(model,
      ShearBuilding{
          .storeys = 2, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m, .storey_height = {5 * m, 4 * m}});
  const std::vector<Peak> ratios = drift_ratios(model, {{"drift", "storey 1", -0.01, "m", 1.5, 0.001, "left"},
                                                        {"drift", "storey 2", 0.01, "m", 2.5},
                                                        {"displacement", "floor 1", 0.2, "m"}});
  ASSERT_EQ(ratios.size(), 2u);
  EXPECT_EQ(ratios[0].quantity, "drift_ratio");
  EXPECT_EQ(ratios[0].where, "storey 1");
  EXPECT_EQ(ratios[0].unit, "%");
  EXPECT_DOUBLE_EQ(ratios[0].value, -0.2);
  EXPECT_DOUBLE_EQ(ratios[0].error, 0.02);
  EXPECT_EQ(ratios[0].time, 1.5);
  EXPECT_EQ(ratios[0].side, "left");
  EXPECT_DOUBLE_EQ(ratios[1].value, 0.25);
}

TEST(DriftRatios, StoreysWithoutHeightsHaveNone) {
  Model model;
  const NodeId low = add(model, Node{.name = "low", .mass = 1 * tonne});
  add(model, ShearSpring{.name = "storey", .lower = ground, .upper = low, .stiffness = 1 * MN / m});
  EXPECT_TRUE(drift_ratios(model, {{"drift", "storey", 0.01, "m"}}).empty());
}

TEST(DriftRatios, AreAmongThePeaksOfARun) {
  Model model;
  const PlanBuilding building = testing::small_plan_building(
      2, {.yield_force = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  add(model, building);
  const CaseResult result = run_case(model, near_fault_pulse({}), {.transient = {.end = 2 * s}});
  for (const auto& [drift, ratio] :
       {std::pair{"corner_drift", "corner_drift_ratio"}, {"drift_x", "drift_ratio_x"}, {"drift_y", "drift_ratio_y"}})
    for (const char* floor : {"floor 1", "floor 2"})
      EXPECT_DOUBLE_EQ(testing::peak(result, ratio, floor), testing::peak(result, drift, floor) * (100.0 / 3.5));
}

}  // namespace
}  // namespace moat
