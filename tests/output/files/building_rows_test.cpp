#include "output/files/building_rows.hpp"

#include "moat.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

using namespace units;

CaseResult two_buildings(Length gap) {
  Model model;
  const Building tower = add(model, ShearBuilding{.name = "tower",
                                                  .storeys = 2,
                                                  .floor_mass = 500 * tonne,
                                                  .storey_stiffness = 1 * GN / m,
                                                  .damping = {.ratio = 0.05},
                                                  .base_mass = 550 * tonne,
                                                  .isolation = LeadRubberBearing{.yield_force = 1 * MN,
                                                                                 .yield_displacement = 1 * cm,
                                                                                 .post_yield_stiffness = 8 * MN / m}});
  const Building old = add(
      model, ShearBuilding{.name = "old", .storeys = 1, .floor_mass = 300 * tonne, .storey_stiffness = 50 * MN / m});
  add(model, Gap{.name = "passage",
                 .left = tower.floor(1),
                 .right = old.floor(1),
                 .clearance = gap,
                 .law = LinearElastic{.stiffness = 1 * GN / m}});
  return run_case(model, near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g),
                  {.transient = {.end = 5 * s}, .error_bars = ErrorBarMode::never});
}

TEST(BuildingTable, HasARowForEveryBuilding) {
  const CaseResult result = two_buildings(2 * cm);
  const BuildingTable table = building_table(result);
  EXPECT_EQ(table.headings, (std::vector<std::string>{"gap", "margin", "isolators", "drift", "acceleration"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].name, "tower");
  EXPECT_EQ(table.rows[0].cells[0].value, "closed, right");
  EXPECT_EQ(table.rows[1].cells[0].value, "closed, left") << "the other side of the same gap";
  EXPECT_TRUE(table.rows[0].cells[1].value.starts_with("-")) << table.rows[0].cells[1].value;
  EXPECT_EQ(table.rows[0].cells[1].value, table.rows[1].cells[1].value);
  EXPECT_TRUE(table.rows[0].cells[2].where.starts_with("tower bearings at "));
  EXPECT_EQ(table.rows[1].cells[2].value, "") << "it stands on the ground";
  EXPECT_TRUE(table.rows[0].cells[3].value.ends_with(" %"));
  EXPECT_TRUE(table.rows[1].cells[4].value.ends_with(" g"));
  EXPECT_TRUE(table.rows[1].cells[4].more.ends_with(" m/s^2"));
  EXPECT_TRUE(table.rows[1].cells[4].where.starts_with("old floor 1 at ")) << "each has its own largest value";
}

// A wall is a body on the ground: its acceleration would hide that of the building.
TEST(BuildingTable, LeavesOutWallsThatGiveWay) {
  Model model;
  const Building house = add(
      model, ShearBuilding{.name = "house", .storeys = 1, .floor_mass = 300 * tonne, .storey_stiffness = 50 * MN / m});
  add(model, Moat{.around = house.floor(1),
                  .clearance = 1 * cm,
                  .law = LinearElastic{.stiffness = 1 * GN / m},
                  .wall = FlexibleWall{.mass = 10 * tonne, .stiffness = 100 * MN / m}});
  const CaseResult result = run_case(model, near_fault_pulse().scaled_to_pga(0.4 * g),
                                     {.transient = {.end = 5 * s}, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.buildings.size(), 3U);
  const BuildingTable table = building_table(result);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].name, "house");
  // The margin names the motion of the wall beside the indentation of its face.
  double motion = 0.0;
  for (const Peak& peak : result.peaks)
    if (peak.where.ends_with(" wall") && peak.quantity == "displacement") motion = std::max(motion, peak.magnitude());
  ASSERT_GT(motion, 1e-3);
  EXPECT_TRUE(table.rows[0].cells[1].more.starts_with("and the wall ")) << table.rows[0].cells[1].more;
  EXPECT_LE(std::stod(table.rows[0].cells[1].more.substr(13)), 100.0 * motion * 1.01);
}

TEST(BuildingTable, SaysWhichShareOfTheClearanceIsLeft) {
  const BuildingTable table = building_table(two_buildings(5 * m));
  const BuildingCell& margin = table.rows[0].cells[1];
  EXPECT_EQ(table.rows[0].cells[0].value, "open");
  // Both are rounded: "483.1 cm", "96.6 %".
  EXPECT_NEAR(std::stod(margin.value) / 5.0, std::stod(margin.more), 0.1);
  EXPECT_TRUE(margin.where.starts_with("passage at "));
}

// A peak after its building rocked has a mark, which is no name of an element.
TEST(BuildingTable, NamesThePlaceOfPeaksThatRocked) {
  CaseResult result;
  result.buildings = {{.name = "house", .floors = {"floor 1"}, .places = {"floor 1", "storey 1"}}};
  result.peaks = {{"absolute_acceleration", "floor 1", -4.903325, "m/s^2", 1.5, 0.0, "rocked"},
                  {"drift_ratio", "storey 1", 0.5, "%", 2.5, 0.0, "column 3, rocked"}};
  const BuildingTable table = building_table(result);
  ASSERT_EQ(table.rows.size(), 1u);
  std::vector<std::string> where;
  for (const BuildingCell& cell : table.rows[0].cells) where.push_back(cell.where);
  EXPECT_EQ(where, (std::vector<std::string>{"column 3 at 2.500 s", "floor 1 at 1.500 s"}));
}

TEST(BuildingTable, IsTextForTheTerminal) {
  CaseResult result;
  EXPECT_EQ(text_of(building_table(result)), "");
  result.buildings = {{.name = "house", .floors = {"floor 1"}, .places = {"floor 1", "storey 1"}},
                      {.name = "shed", .floors = {"roof"}, .places = {"roof"}}};
  result.peaks = {{"absolute_acceleration", "floor 1", -4.903325, "m/s^2", 1.5},
                  {"drift_ratio", "storey 1", 0.5, "%", 2.5},
                  {"absolute_acceleration", "roof", 9.80665, "m/s^2", 12.5}};
  EXPECT_EQ(text_of(building_table(result)),
            "         drift                acceleration\n"
            "  house  0.5000 %             0.5000 g\n"
            "                              4.903 m/s^2\n"
            "         storey 1 at 2.500 s  floor 1 at 1.500 s\n"
            "  shed   -                    1.000 g\n"
            "                              9.807 m/s^2\n"
            "                              roof at 12.500 s\n");
}

}  // namespace
}  // namespace moat
