#include "report/sections.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::count;

TEST(Drawing, ShowsEveryFloorStoreyBearingGapAndWall) {
  const std::string html = html::drawing_section(testing_report::line_result());
  EXPECT_EQ(count(html, "class=\"floor\""), 3u);
  EXPECT_EQ(count(html, "class=\"storey\""), 2u);
  EXPECT_EQ(count(html, "class=\"bearing\""), 1u);
  EXPECT_EQ(count(html, "class=\"gap\""), 2u);
  EXPECT_EQ(count(html, "class=\"wall\""), 2u);
  EXPECT_NE(html.find("Elevation at rest, to scale."), std::string::npos);
  EXPECT_EQ(count(html, " hidden>"), 1u) << "the controls, until the script shows them";
}

TEST(Drawing, AFloorMovesWithItsNodeAndAWallWithNothing) {
  const std::string html = html::drawing_section(testing_report::line_result());
  EXPECT_TRUE(std::regex_search(
      html, std::regex{R"re(data-name="floor 2" points="[^"]*" data-move="2:1,0 2:1,0 2:1,0 2:1,0")re"}));
  EXPECT_TRUE(std::regex_search(
      html, std::regex{R"re(data-name="moat right wall" points="[^"]*" data-spread="0.1,0 [^"]*">)re"}));
}

TEST(Drawing, ShowsThePlanWithTheOrbitsOfTheBase) {
  const std::string html = html::drawing_section(testing_report::plan_result());
  EXPECT_EQ(count(html, "class=\"floor\""), 1u) << "the base";
  EXPECT_EQ(count(html, "class=\"upper\""), 1u);
  EXPECT_EQ(count(html, "class=\"wall\""), 4u);
  EXPECT_EQ(count(html, "class=\"gap\""), 8u);
  EXPECT_EQ(count(html, "class=\"orbit\""), 5u) << "four corners and the centre of mass";
}

TEST(Drawing, AFixedBuildingStandsOnTheGround) {
  using namespace units;
  Model model;
  add(model, ShearBuilding{.storeys = 2, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m});
  const std::string html = html::drawing_section(
      run_case(model, near_fault_pulse({}), {.transient = {.end = 0.05 * s}, .error_bars = ErrorBarMode::never}));
  EXPECT_EQ(count(html, "class=\"ground\""), 1u);
  // From height 0, 3.5 m below floor 1.
  EXPECT_TRUE(std::regex_search(html, std::regex{R"re(data-name="storey 1" points="-4.7,-?0 4.7,-?0 )re"})) << html;
  EXPECT_TRUE(
      std::regex_search(html, std::regex{R"re(class="ground" data-name="ground" points="-5.64,-?0 5.64,-?0")re"}))
      << html;
}

TEST(Drawing, ShowsBearingsInPlan) {
  EXPECT_EQ(count(html::drawing_section(testing_report::plan_result()), "class=\"bearing\""), 4u);
}

TEST(Drawing, EscapesNames) {
  CaseResult result = testing_report::line_result();
  result.scene.cells[0].name = "a<b\"";
  EXPECT_NE(html::drawing_section(result).find("data-name=\"a&lt;b&quot;\""), std::string::npos);
}

TEST(Drawing, IsEmptyWithoutSceneOrHistories) {
  CaseResult result = testing_report::line_result();
  result.histories = {};
  EXPECT_EQ(html::drawing_section(result), "");
  EXPECT_EQ(html::drawing_section({}), "");
}

TEST(Drawing, IsLeftOutForVeryManyNodes) {
  using namespace units;
  for (const int storeys : {most_drawn_nodes, most_drawn_nodes + 1}) {
    Model model;
    add(model, ShearBuilding{.storeys = storeys, .floor_mass = 1 * tonne, .storey_stiffness = 1 * MN / m});
    const CaseResult result =
        run_case(model, near_fault_pulse({}), {.transient = {.end = 0.05 * s}, .error_bars = ErrorBarMode::never});
    EXPECT_EQ(html::drawing_section(result).empty(), storeys > most_drawn_nodes);
  }
}

}  // namespace
}  // namespace moat
