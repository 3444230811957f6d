#include "design/sheet_building_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "message_of.hpp"
#include "moat.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const LeadRubberBearing bearing{
    .yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m};

// 800 t and twice 700 t; 20 x 12 m; a bearing at each corner.
TEST(SheetBuildingOf, HasTheNumbersOfItsModel) {
  PlanBuilding given = testing::small_plan_building(2, bearing);
  given.storey_height = {4 * m, 3 * m};
  given.mass_offset = PlanPosition{0.6 * m, 0 * m};
  Model model;
  add(model, given);
  const SheetBuilding building = sheet_building_of(model, bearing);
  const double weight = 9.80665e3;  // of 1 t, N
  EXPECT_NEAR(building.weight.si(), 2200 * weight, 1e-6);
  ASSERT_EQ(building.floors.size(), 2u);
  EXPECT_NEAR(building.floors[1].weight.si(), 700 * weight, 1e-6);
  EXPECT_NEAR(building.floors[0].height.si(), 4.0, 1e-12);
  EXPECT_NEAR(building.floors[1].height.si(), 7.0, 1e-12);
  EXPECT_NEAR(building.shorter_side.si(), 12.0, 1e-12);
  EXPECT_NEAR(building.longer_side.si(), 20.0, 1e-12);
  ASSERT_EQ(building.bearings.size(), 4u);
  for (const PlanPosition& at : building.bearings) {
    EXPECT_NEAR(std::abs(at.x.si()), 10.0, 1e-12);
    EXPECT_NEAR(std::abs(at.y.si()), 6.0, 1e-12);
  }
  // Both floors are off by 0.6 m, the base is not.
  EXPECT_NEAR(building.eccentricity.si(), 0.6 * 1400.0 / 2200.0, 1e-12);
  building.check(Check{"test", ""});
}

// Equal floors m on equal storeys K = 4 x 100 MN/m, held at the base: w_1 = 2 sqrt(K/m) sin(pi/10) for two.
TEST(SheetBuildingOf, HasThePeriodOnAFixedBase) {
  const double w = std::sqrt(400e6 / 700e3);
  for (const auto& [storeys, expected] : {std::pair{1, w}, {2, 2.0 * w * std::sin(std::numbers::pi / 10.0)}}) {
    Model model;
    add(model, testing::small_plan_building(storeys, bearing));
    EXPECT_NEAR(sheet_building_of(model, bearing).fixed_base_period.si() / (2.0 * std::numbers::pi / expected), 1.0,
                1e-9)
        << storeys;
  }
}

TEST(SheetBuildingOf, CountsTheTowersOfAPodium) {
  Model model;
  PlanBuilding podium = testing::small_plan_building(1, bearing);
  podium.name = "podium";
  const PlanBuildingParts parts = add(model, podium);
  StoreyTable storeys;
  storeys.floors.push_back({.name = "floor 1",
                            .height = 5 * m,
                            .mass = 100 * tonne,
                            .rotary_inertia = 1000 * tonne * m * m,
                            .stiffness_x = 90 * MN / m,
                            .stiffness_y = 90 * MN / m,
                            .rotational_stiffness = 9 * GN * m,
                            .outline = rectangle(6 * m, 6 * m)});
  add(model, Superstructure{.name = "east", .storeys = storeys, .on = {parts.base}});
  const SheetBuilding building = sheet_building_of(model, bearing, "podium base");
  EXPECT_EQ(building.name, "podium");
  EXPECT_NEAR(building.weight.si(), 1600 * 9.80665e3, 1e-6);
  ASSERT_EQ(building.floors.size(), 2u);
  EXPECT_NEAR(building.floors[1].height.si(), 5.0, 1e-12);
}

TEST(SheetBuildingOf, RefusesModelsWithoutSuchABase) {
  Model line, plan, fixed;
  add(line, ShearBuilding{.storeys = 1,
                          .floor_mass = 400 * tonne,
                          .storey_stiffness = 700 * MN / m,
                          .base_mass = 450 * tonne,
                          .isolation = bearing});
  add(plan, testing::small_plan_building(1, bearing));
  PlanBuilding without = testing::small_plan_building(1, bearing);
  without.bearings = {};
  without.base_mass = {};
  add(fixed, without);
  const std::string refusal =
      "the model has no building in plan on this base. Give the name of the base of a building in plan.";
  EXPECT_EQ(message_of([&] { (void)sheet_building_of(line, bearing); }), "sheet_building_of \"base\": " + refusal);
  EXPECT_EQ(message_of([&] { (void)sheet_building_of(plan, bearing, "cellar"); }),
            "sheet_building_of \"cellar\": " + refusal);
  EXPECT_EQ(message_of([&] { (void)sheet_building_of(fixed, bearing); }), "sheet_building_of \"base\": " + refusal);
}

}  // namespace
}  // namespace moat
