// Warnings about motions beyond all records, gaps whose sides are exchanged, bearings that never yield, and periods of
// other units.

#include "analyses/case/input_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

TEST(MotionWarnings, DoubtAccelerationsBeyondAllRecords) {
  const GroundMotion motion{"strong", 0.01, {0.0, 9.80665, 0.0}};
  EXPECT_TRUE(motion_warnings(motion.scaled_by(4.9)).empty());
  EXPECT_EQ(
      motion_warnings(motion.scaled_by(980.665)),
      (std::vector<std::string>{"The peak acceleration of the ground is 980.665 g; no record is as strong as 5 g. "
                                "Check the unit of the record and its scale factor (980.665)."}));
}

TEST(MotionWarnings, SayThatARecordIsVertical) {
  const GroundMotion motion{"KBU-UP", 0.01, {0.0, 1.0, 0.0}, {"KBU-UP is a vertical record: its name says \"UP\"."}};
  EXPECT_EQ(motion_warnings(motion.scaled_by(2.0)),
            (std::vector<std::string>{"KBU-UP is a vertical record: its name says \"UP\". It shakes the model "
                                      "horizontally. Give a horizontal component."}));
}

TEST(ModelWarnings, NameAGapWhoseSidesAreExchanged) {
  for (const bool exchanged : {false, true}) {
    Model model;
    const NodeId west = add(model, Node{.name = "west", .mass = 1 * kg, .x = -3 * m});
    const NodeId east = add(model, Node{.name = "east", .mass = 1 * kg, .x = 4 * m});
    add(model, Gap<Hertz>{.name = "between",
                          .left = exchanged ? east : west,
                          .right = exchanged ? west : east,
                          .clearance = 10 * cm,
                          .law = {.stiffness = 1000 * N / m_3_2}});
    const std::vector<std::string> warnings = model_warnings(model);
    ASSERT_EQ(warnings.size(), exchanged ? 1u : 0u);
    if (exchanged) {
      EXPECT_EQ(
          warnings[0],
          "Gap \"between\": its left side \"east\" has x = 4 m and its right side \"west\" x = -3 m. Exchange .left "
          "and .right, or correct the positions.");
    }
  }
}

ShearBuilding house(Stiffness storey_stiffness, Force yield_force = 1 * MN) {
  return {.name = "house",
          .storeys = 3,
          .floor_mass = 500 * tonne,
          .storey_stiffness = storey_stiffness,
          .base_mass = 500 * tonne,
          .isolation = LeadRubberBearing{
              .yield_force = yield_force, .yield_displacement = 1 * cm, .post_yield_stiffness = 8 * MN / m}};
}

// The first period of three equal storeys is 2 pi sqrt(m/k)/(2 sin(pi/14)).
TEST(PeriodWarnings, DoubtTheUnitsOfBuildingsThatNobodyBuilds) {
  const auto warnings = [](Stiffness storey) {
    Model model;
    add(model, house(storey));
    return period_warnings(model);
  };
  EXPECT_TRUE(warnings(800 * MN / m).empty());
  const double period = 2.0 * std::numbers::pi * std::sqrt(500e3 / 800.0) / (2.0 * std::sin(std::numbers::pi / 14.0));
  EXPECT_EQ(warnings(800 * N / m),
            (std::vector<std::string>{"The first period of house held at its base is " + to_text(period) +
                                      " s; buildings have 0.02 to 10 s. Check the units of stiffnesses and masses."}));
  EXPECT_EQ(warnings(1e6 * MN / m).size(), 1u);
}

TEST(PeriodWarnings, HoldTheBaseInPlanToo) {
  Model model;
  PlanBuilding building = testing::small_plan_building(
      1, {.yield_force = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  building.columns = grid(2, 2, {.stiffness = 100 * N / m});
  add(model, building);
  // 700 t on four columns.
  const std::string period = to_text(2.0 * std::numbers::pi * std::sqrt(700e3 / 400.0));
  ASSERT_EQ(period_warnings(model).size(), 1u);
  EXPECT_NE(period_warnings(model)[0].find("of the building held at its base is " + period), std::string::npos)
      << period_warnings(model)[0];
  EXPECT_EQ(run_case(model, near_fault_pulse({}), {.transient = {.end = 0.1 * s}}).warnings[0],
            period_warnings(model)[0]);
}

// 2000 t: 19.6 MN.
TEST(ModelWarnings, NameBearingsThatNeverYield) {
  const auto warnings = [](Force yield_force) {
    Model model;
    add(model, house(800 * MN / m, yield_force));
    return model_warnings(model);
  };
  EXPECT_TRUE(warnings(1 * MN).empty());
  // 0.08 MN of post-yield stiffness at d_y do not count.
  EXPECT_EQ(
      warnings(117.76 * MN),
      (std::vector<std::string>{"The isolators of house have a strength of 600 % of the weight on them; 3 to 10 % "
                                "is usual, and above 30 % they hardly ever yield. Check the units of yield_force, "
                                "strength and masses."}));
}

TEST(ModelWarnings, NameACentreOfMassOutsideItsFloor) {
  Model model;
  PlanBuilding building = testing::small_plan_building(
      1, {.yield_force = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  // An L without its corner at the upper right; its centroid lies at (-5/3, -1) m.
  building.outline = PlanOutline{
      .corners = {
          {-10 * m, -6 * m}, {10 * m, -6 * m}, {10 * m, 0 * m}, {0 * m, 0 * m}, {0 * m, 6 * m}, {-10 * m, 6 * m}}};
  building.mass_offset = {7 * m, 4 * m};
  add(model, building);
  const std::vector<std::string> warnings = model_warnings(model);
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& each) {
    return each.starts_with("The centre of mass of \"floor 1\" at (5.3") &&
           each.ends_with("m is outside its outline. Correct the centre of mass, its offset or the outline.");
  })) << (warnings.empty() ? "no warning" : warnings.back());
}

TEST(ModelWarnings, SayNothingOfNodesWithoutPositions) {
  Model model;
  const NodeId one = add(model, Node{.name = "one", .mass = 1 * kg});
  const NodeId other = add(model, Node{.name = "other", .mass = 1 * kg});
  add(model,
      Gap<Hertz>{.name = "gap", .left = one, .right = other, .clearance = 1 * cm, .law = {.stiffness = 1 * N / m_3_2}});
  EXPECT_TRUE(model_warnings(model).empty());
}

}  // namespace
}  // namespace moat
