#include "report/sections.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::count;

TEST(PeakSection, ShowsErrorsAndTheirMethod) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.532812, "m", 4.5, 0.00021},
                  {"displacement", "floor 1", 0.532812, "m", 4.5, 0.0031}};
  result.error_bars = {.checked = true, .companion = "The same & finer.", .companion_impacts = 7};
  std::string html = html::peak_section(result);
  EXPECT_NE(html.find("<td class=\"number\">53.28</td><td class=\"error\">&plusmn; 0.03</td>"), std::string::npos);
  EXPECT_NE(html.find("53.3<span class=\"missing\">0</span></td><td class=\"error\">&plusmn; 0.4</td>"),
            std::string::npos);
  EXPECT_NE(html.find("estimated numerical error"), std::string::npos);
  EXPECT_NE(html.find("The same &amp; finer."), std::string::npos);
  EXPECT_NE(html.find("7 impacts"), std::string::npos);
  result.error_bars.unsettled_peaks = {result.peaks[1]};
  html = html::peak_section(result);
  EXPECT_NE(html.find("<tr class=\"unsettled\"><td>floor 1</td>"), std::string::npos);
  EXPECT_EQ(count(html, "class=\"unsettled\""), 1u);
}

TEST(PeakSection, NamesWhatNeverChanges) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.25, "m", 3.0}, {"friction_coefficient", "bearings", 0.05, "1", 0.0}};
  result.histories.columns = {{"friction_coefficient", "bearings", "1", {0.05, 0.05}}};
  const std::string html = html::peak_section(result);
  EXPECT_NE(html.find("Not listed, because it never changes: friction coefficient.</p>"), std::string::npos) << html;
  EXPECT_EQ(html.find("0.05"), std::string::npos) << html;
}

TEST(PeakSection, NamesSidesWhereTheyAreAndTheDirectionsOfPlan) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.25, "m", 3.0}};
  result.peaks.front().side = "right";
  std::string html = html::peak_section(result);
  EXPECT_NE(html.find(">side</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<p>Positive to the right;"), std::string::npos) << html;
  result.peaks = {{"displacement_y", "base", 0.25, "m", 3.0}};
  result.model.diaphragms.emplace_back();
  html = html::peak_section(result);
  EXPECT_EQ(html.find(">side</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<p>x is positive to the right, y up in plan, rotations counter-clockwise;"), std::string::npos)
      << html;
}

TEST(PeakSection, GivesAccelerationsInGToo) {
  CaseResult result;
  result.peaks = {{"absolute_acceleration", "roof", 4.903325, "m/s^2", 3.0}, {"displacement", "roof", 0.25, "m", 3.0}};
  const std::string html = html::peak_section(result);
  EXPECT_EQ(count(html, "<th class=\"number\" scope=\"col\">g</th>"), 1u);
  EXPECT_NE(html.find("<td class=\"number\">4.903</td><td class=\"number\">0.5000</td>"), std::string::npos) << html;
}

TEST(PeakSection, LeavesOutGapsThatStayedOpen) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.25, "m", 3.0},
                  {"impact_force", "moat left", 0.0, "N", 0.0},
                  {"indentation", "moat left", 0.0, "m", 0.0}};
  const std::string html = html::peak_section(result);
  EXPECT_EQ(html.find("moat left"), std::string::npos);
  EXPECT_EQ(html.find("Impact force"), std::string::npos);
}

// The largest of all bearings is that of one bearing, with its error.
TEST(BearingSection, ListsEveryBearingInPlan) {
  const CaseResult result = testing_report::plan_result();
  for (const char* quantity : {"isolator_deformation", "isolator_force"}) {
    Peak together, largest;
    for (const Peak& peak : result.peaks) {
      if (peak.quantity != quantity) continue;
      if (peak.where == "bearings")
        together = peak;
      else if (peak.magnitude() > largest.magnitude())
        largest = peak;
    }
    EXPECT_EQ(largest.where, together.side);
    EXPECT_EQ(largest.value, together.value);
    EXPECT_GT(largest.error, 0.0);
  }
  const std::string html = html::bearing_section(result);
  for (const char* part :
       {"4 bearings", "<td>bearing 1</td><td>bearings, BiaxialBilinear</td>", ">-10</td>", ">6</td>"})
    EXPECT_NE(html.find(part), std::string::npos) << part << html;
  EXPECT_EQ(html::peak_section(result).find("<tr><td>bearing 1</td>"), std::string::npos)
      << "they have their own table";
  EXPECT_EQ(html::bearing_section(testing_report::line_result()), "");
}

TEST(SectionAtTheEnd, ShowsTheOffsetOfIsolators) {
  CaseResult result;
  EXPECT_EQ(html::section_at_the_end(result), "");
  result.histories.columns = {{"time", "", "s", {0.0, 21.4}},
                              {"isolator_deformation", "bearings", "m", {0.0, -0.0123}}};
  const std::string html = html::section_at_the_end(result);
  EXPECT_NE(html.find("<td>bearings</td><td class=\"number\">-1.230</td>"), std::string::npos) << html;
  EXPECT_NE(html.find("21.400"), std::string::npos) << html;
}

TEST(PeakSection, SaysWhyThereAreNoErrors) {
  CaseResult result;
  result.error_bars.companion = "No error bars: a reason.";
  const std::string html = html::peak_section(result);
  EXPECT_NE(html.find("No error bars: a reason."), std::string::npos);
  EXPECT_EQ(html.find("&plusmn;"), std::string::npos);
}

TEST(PeakSection, OfVeryManyPlacesShowsTheLargest) {
  CaseResult result;
  for (int i = 0; i < 1000; ++i) {
    result.peaks.push_back({"drift", "storey " + std::to_string(i), (i % 2 == 0 ? 1e-5 : -1e-5) * i, "m"});
    result.clearances.push_back({"gap " + std::to_string(i), 1.0, 1e-3 * i});
  }
  std::string html = html::peak_section(result);
  EXPECT_EQ(count(html, "<td>storey "), html::most_places);
  EXPECT_NE(html.find("<td>storey 960</td>"), std::string::npos);
  EXPECT_EQ(html.find("<td>storey 959</td>"), std::string::npos);
  EXPECT_NE(html.find("summary.json has all 1000 peaks"), std::string::npos);
  html = html::clearance_section(result);
  EXPECT_EQ(count(html, "<td>gap "), html::most_places);
  EXPECT_NE(html.find("<td>gap 39</td>"), std::string::npos);
}

TEST(PeakSection, ManyEqualPeaksAreNotAllShown) {
  CaseResult result;
  for (int i = 0; i < 100; ++i) result.peaks.push_back({"drift", "storey " + std::to_string(i), 0.01, "m"});
  EXPECT_EQ(count(html::peak_section(result), "<td>storey "), html::most_places);
}

}  // namespace
}  // namespace moat
