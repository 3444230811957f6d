#include "output/report.hpp"

#include <cmath>
#include <regex>

#include "output_testing.hpp"

namespace moat {
namespace {

using testing_output::read_file;

class Report : public testing_output::InFolder {
 protected:
  std::string written(const CaseResult& result) const {
    write_report_html(result, folder);
    return read_file(folder / "report.html");
  }
};

CaseResult example() {
  CaseResult result;
  result.title = "Gap < 10 cm & \"hard\"";
  result.motion = {"record A", 3.92266, 0.45, 0.005, 28.0};
  result.buildings = {{.base = "base", .floors = {"floor 1", "floor 5"}, .isolators = {"bearings"}}};
  result.periods = {{"isolated", 2.125}};
  result.peaks = {{"displacement", "base", 0.1234567, "m", 4.5}, {"impact_force", "moat left", 25.65e6, "N", 4.25}};
  result.impacts = {{"moat left", 3.25, 0.125, 0.5, 0.01, 2.5e7, 0.75}};
  result.solver.accepted_steps = 11'213;
  result.assumptions = {"Average acceleration."};
  Table& table = result.histories;
  table.columns = {{"time", "", "s", {}},
                   {"displacement", "base", "m", {}},
                   {"displacement", "floor 1", "m", {}},
                   {"displacement", "floor 5", "m", {}},
                   {"absolute_acceleration", "base", "m/s^2", {}},
                   {"absolute_acceleration", "floor 5", "m/s^2", {}},
                   {"impact_force", "moat left", "N", {}},
                   {"isolator_force", "bearings", "N", {}}};
  for (int i = 0; i < 400; ++i) {
    table.columns[0].values.push_back(0.05 * i);
    for (std::size_t column = 1; column < table.columns.size(); ++column)
      table.columns[column].values.push_back(std::sin(0.1 * i + 0.3 * static_cast<double>(column)));
  }
  return result;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(Report, HoldsEverythingItPromises) {
  const std::string html = written(example());
  EXPECT_NE(html.find("<title>Gap &lt; 10 cm &amp; &quot;hard&quot;</title>"), std::string::npos);
  for (const char* part : {"record A", "3.923 m/s²", "45.00 cm/s", "2.125 s", "12.35", "25650", "moat left", "11213",
                           "Average acceleration.", "<h2>Histories</h2>", "<h2>Hysteresis</h2>", "displacement [cm]",
                           "absolute acceleration [m/s²]", "impact force [kN]", "base displacement [cm]",
                           "isolator force [kN]", "floor 5"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("floor 1"), std::string::npos) << "only base and top are drawn";
  EXPECT_EQ(count(html, "<svg "), 2u);
  EXPECT_EQ(count(html, "<table>"), count(html, "</table>"));
}

TEST_F(Report, SaysWhatWasComputed) {
  CaseResult result = example();
  result.provenance = {"moat run tower.cpp --gap '20 cm'",
                       "/home/me/tower.cpp",
                       "c0ffee",
                       {{"gap", "20 cm"}},
                       "0.1.0",
                       "0123456789",
                       "2026-01-31T12:00:00Z"};
  result.motion.file = "/records/a.AT2";
  result.motion.sha256 = "beef";
  result.motion.scale_factor = 1.25;
  result.motion.notes = {"PEER <header>"};
  result.model = {
      {{"base", 550e3, 0.0, 0.0}},
      {{"moat left", "HertzDamp", "base", "ground", {{"clearance", 0.1, "m"}, {"restitution", 0.65, "1"}}}}};
  result.clearances = {{"moat left", 0.1, -0.01, 3.25}};
  const std::string html = written(result);
  for (const char* part :
       {"moat run tower.cpp --gap '20 cm'", "/home/me/tower.cpp", "c0ffee", "--gap</td><td class=\"text\">20 cm",
        "0.1.0, commit 0123456789", "2026-01-31T12:00:00Z", "/records/a.AT2", "beef", "1.25", "PEER &lt;header&gt;",
        "550000", "HertzDamp", "clearance 0.1 m, restitution 0.65", "Clearance left", "-1.000", "of 10 cm"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST_F(Report, ShowsTheBeginningOfALongModel) {
  CaseResult result = example();
  for (int i = 0; i < 2000; ++i) result.model.nodes.push_back({"node " + std::to_string(i), 1.0, 0.0, 0.0});
  const std::string html = written(result);
  EXPECT_NE(html.find("2000 nodes"), std::string::npos);
  EXPECT_NE(html.find("... and 1900 more in summary.json"), std::string::npos);
  EXPECT_EQ(html.find("node 100<"), std::string::npos);
}

TEST_F(Report, TellsImpactsWithinMillisecondsApart) {
  CaseResult result = example();
  result.impacts = {{"a", 12.5512, 0.001, 0.5, 0.01, 2.5e7, 1.787}, {"a", 12.5538, 0.001, 0.5, 0.01, 2.5e7, 0.75}};
  const std::string html = written(result);
  EXPECT_NE(html.find("12.5512"), std::string::npos);
  EXPECT_NE(html.find("12.5538"), std::string::npos);
  EXPECT_NE(html.find("Rebound ratio: speed of separation over speed of approach"), std::string::npos);
}

TEST_F(Report, ShowsSmallErrorsOfTheEnergyAsTheyAre) {
  CaseResult result = example();
  result.energy.equation_residual = 1.234e-9;
  EXPECT_NE(written(result).find("Residual of the equations</td><td class=\"number\">1.2e-12 kJ"), std::string::npos);
}

TEST_F(Report, IsUtf8WhateverTheNames) {
  CaseResult result = example();
  result.title = "T\xFCr";
  EXPECT_NE(written(result).find("T\xEF\xBF\xBDr"), std::string::npos);
}

TEST_F(Report, DrawsOfferedQuantities) {
  CaseResult result = example();
  result.offered = {{"roof_tilt", "tower", "m"}, {"roof_tilt", "annex", "m"}, {"hole", "tower", "1"}};
  Column tilt = result.histories.columns[1];
  for (const char* where : {"tower", "annex"}) {
    tilt.quantity = "roof_tilt";
    tilt.where = where;
    result.histories.columns.push_back(tilt);
  }
  tilt.quantity = "hole";
  tilt.values[7] = NAN;
  result.histories.columns.push_back(tilt);
  const std::string html = written(result);
  EXPECT_EQ(count(html, ">Roof tilt</text>"), 1u) << "one chart of both places";
  EXPECT_EQ(html.find("Hole"), std::string::npos) << "a curve with a hole cannot be drawn";
}

TEST_F(Report, NeedsNothingElse) {
  std::string html = written(example());
  // The name of the SVG language is not an address that is fetched.
  html = std::regex_replace(html, std::regex{R"re( xmlns="http://www\.w3\.org/2000/svg")re"}, "");
  for (const char* reference : {"://", "src=", "href=", "url(", "@import", "<link", "<script", "<iframe"})
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  EXPECT_EQ(html.find(" id="), std::string::npos) << "ids of two charts would clash";
}

TEST_F(Report, ShowsErrorsAndSaysWhatTheyAre) {
  CaseResult result = example();
  result.peaks = {{"displacement", "base", 0.532812, "m", 4.5, 0.00021},
                  {"displacement", "floor 1", 0.532812, "m", 4.5, 0.0031}};
  result.error_bars = {.checked = true, .companion = "The same & finer.", .companion_impacts = 7};
  std::string html = written(result);
  EXPECT_NE(html.find("<td class=\"number\">53.28</td><td class=\"error\">&plusmn; 0.03</td>"), std::string::npos);
  EXPECT_NE(html.find("53.3<span class=\"missing\">0</span></td><td class=\"error\">&plusmn; 0.4</td>"),
            std::string::npos);
  EXPECT_NE(html.find("estimated numerical error"), std::string::npos);
  EXPECT_NE(html.find("The same &amp; finer."), std::string::npos);
  EXPECT_NE(html.find("7 impacts"), std::string::npos);
  EXPECT_EQ(html.find("The case is sensitive"), std::string::npos);
  result.error_bars.sensitive = true;
  result.error_bars.reason = "1 < 2 peaks are not settled";
  result.error_bars.unsettled = {result.peaks[1]};
  html = written(result);
  EXPECT_NE(html.find("The case is sensitive:</strong> 1 &lt; 2 peaks are not settled."), std::string::npos);
  EXPECT_NE(html.find("<tr class=\"unsettled\"><td>floor 1</td>"), std::string::npos);
  EXPECT_EQ(count(html, "class=\"unsettled\""), 1u);
}

TEST_F(Report, SaysWhyThereAreNoErrors) {
  CaseResult result = example();
  result.error_bars.companion = "No error bars: a reason.";
  const std::string html = written(result);
  EXPECT_NE(html.find("No error bars: a reason."), std::string::npos);
  EXPECT_EQ(html.find("&plusmn;"), std::string::npos);
}

TEST_F(Report, LeavesOutChartsWithoutColumns) {
  CaseResult result = example();
  result.histories.columns.pop_back();
  EXPECT_EQ(count(written(result), "<svg "), 1u);
  result.histories = {};
  result.impacts.clear();
  const std::string html = written(result);
  EXPECT_EQ(count(html, "<svg "), 0u);
  EXPECT_NE(html.find("No contact."), std::string::npos);
}

TEST_F(Report, ReportsAFolderThatIsMissing) {
  EXPECT_THROW(write_report_html(example(), folder / "missing"), FileError);
}

}  // namespace
}  // namespace moat
