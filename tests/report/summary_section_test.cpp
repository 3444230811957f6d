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
                  {"impact_force", "moat left", 25.65e6, "N", 4.25}};
  result.clearances = {{"moat left", 0.1, -0.01, 3.25}, {"moat right", 0.1, 0.02, 3.25}};
  result.impacts = {{.where = "moat left", .start = 4.2}};
  return result;
}

TEST(SummarySection, ShowsTheLargestOfEachQuantityWithItsError) {
  const std::string html = html::summary_section(example());
  EXPECT_NE(html.find("record &lt;A&gt;, peak acceleration 3.923 m/s²"), std::string::npos);
  EXPECT_NE(html.find("-53.28 <small>&plusmn; 0.03</small> <small>cm</small>"), std::string::npos);
  EXPECT_NE(html.find("floor 5 at 4.500 s"), std::string::npos);
  EXPECT_NE(html.find("25650"), std::string::npos);
  EXPECT_NE(html.find("moat left, of 10 cm"), std::string::npos);
  EXPECT_NE(html.find("first at 4.200 s"), std::string::npos);
  EXPECT_EQ(count(html, "class=\"card\""), 4u) << "no energy, no drift, no acceleration";
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
  result.error_bars.unsettled = {result.peaks[1]};
  EXPECT_EQ(count(html::summary_section(result), "class=\"card unsettled\""), 1u);
}

TEST(SummarySection, ShowsCornersInPlan) {
  const std::string html = html::summary_section(testing_report::plan_result());
  for (const char* part : {"Largest corner displacement", "Largest corner drift", "Largest corner acceleration",
                           "Largest isolator deformation", "Largest impact force", "Error of the energy balance"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(WarningSection, ShowsVerdictAndWarnings) {
  CaseResult result = example();
  EXPECT_EQ(html::warning_section(result), "");
  result.warnings = {"a < b"};
  result.error_bars.sensitive = true;
  result.error_bars.reason = "1 < 2 peaks are not settled";
  const std::string html = html::warning_section(result);
  EXPECT_NE(html.find("<li>a &lt; b</li>"), std::string::npos);
  EXPECT_NE(html.find("The case is sensitive:</strong> 1 &lt; 2 peaks are not settled."), std::string::npos);
}

}  // namespace
}  // namespace moat
