#include "report/sections.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::count;

CaseResult example() {
  CaseResult result;
  result.motion = {"record <A>", 3.92266, 0.45, 0.005, 28.0};
  result.peaks = {{"displacement", "base", 0.1, "m", 4.5, 0.00021},
                  {"displacement", "floor 5", -0.532812, "m", 4.5, 0.00021},
                  {"absolute_acceleration", "floor 5", -5.6006, "m/s^2", 4.5, 0.0023},
                  {"impact_force", "moat left", 25.65e6, "N", 4.25}};
  result.buildings = {{.name = "house <1>",
                       .base = "base",
                       .floors = {"floor 5"},
                       .gaps = {{"moat left", "left"}, {"moat right", "right"}},
                       .places = {"base", "floor 5", "moat left", "moat right"}}};
  result.clearances = {{"moat left", 0.1, -0.01, 3.25}, {"moat right", 0.1, 0.02, 3.25}};
  result.impacts = {{.where = "moat left", .start = 4.2}};
  return result;
}

TEST(SummarySection, ShowsARowForEveryBuilding) {
  const std::string html = html::summary_section(example());
  EXPECT_NE(html.find("record &lt;A&gt;, peak acceleration 3.923 m/s²"), std::string::npos);
  EXPECT_NE(html.find("3.923 m/s² (0.4 g)"), std::string::npos) << html;
  EXPECT_NE(html.find("<th scope=\"row\">house &lt;1&gt;</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<div class=\"value\">closed, left</div><div>1 impact</div>"), std::string::npos) << html;
  EXPECT_NE(html.find("<div class=\"value\">-1.000 cm</div><div>-10 %</div>"), std::string::npos) << html;
  EXPECT_NE(html.find("<div class=\"value\">0.5711 g</div><div>5.601 &plusmn; 0.003 m/s²</div>"), std::string::npos)
      << html;
  EXPECT_NE(html.find("<div class=\"where\">floor 5 at 4.500 s</div>"), std::string::npos) << html;
  EXPECT_NE(html.find("25650"), std::string::npos);
  EXPECT_NE(html.find("first at 4.200 s"), std::string::npos);
  EXPECT_EQ(count(html, "class=\"card\""), 2u) << "force and impacts; no energy";
}

TEST(SummarySection, NamesTheEnergyThatItsErrorIsComparedWith) {
  CaseResult result = example();
  result.energy.largest_input = 5e6;
  result.energy.largest_kinetic = 2e6;
  EXPECT_NE(html::summary_section(result).find("of the largest input, 5000 kJ"), std::string::npos);
  result.energy.largest_kinetic = 8e6;
  EXPECT_NE(html::summary_section(result).find("of the largest kinetic energy, 8000 kJ"), std::string::npos);
}

TEST(SummarySection, ShadesWhatIsNotSettled) {
  CaseResult result = example();
  result.error_bars.unsettled_peaks = {result.peaks[2]};
  EXPECT_EQ(count(html::summary_section(result), "<td class=\"unsettled\""), 1u);
  result.error_bars.unsettled_peaks = {result.peaks[3]};
  EXPECT_EQ(count(html::summary_section(result), "class=\"card unsettled\""), 1u);
}

TEST(SummarySection, SaysNothingOfContactsWhereThereAreNone) {
  CaseResult result = example();
  result.impacts.clear();
  result.peaks.back().value = 0.0;
  const std::string html = html::summary_section(result);
  EXPECT_EQ(html.find("Largest impact force"), std::string::npos);
  EXPECT_NE(html.find("<div class=\"value\">open</div>"), std::string::npos);
}

TEST(SummarySection, ShowsCornersInPlan) {
  const std::string html = html::summary_section(testing_report::plan_result());
  for (const char* part :
       {"<th scope=\"col\">Margin</th>", "<th scope=\"col\">Isolators</th>", "closed, ",
        "<div class=\"where\">bearing ", " %</div>", " g</div>", "Largest impact force", "Error of the energy balance"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(WarningSection, ShowsVerdictAndWarnings) {
  CaseResult result = example();
  EXPECT_EQ(html::warning_section(result), "");
  result.warnings = {"a < b"};
  result.error_bars.unsettled = true;
  result.error_bars.reason = "1 < 2 peaks are not settled";
  const std::string html = html::warning_section(result);
  EXPECT_NE(html.find("<li>a &lt; b</li>"), std::string::npos);
  EXPECT_NE(html.find("The case is not settled:</strong> 1 &lt; 2 peaks are not settled."), std::string::npos);
}

}  // namespace
}  // namespace moat
