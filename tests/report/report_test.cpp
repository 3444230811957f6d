#include "report/report.hpp"

#include <cmath>
#include <regex>

#include "in_folder.hpp"
#include "plan_facts.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing::read_file;
using testing_report::count;

class Report : public testing::InFolder {
 protected:
  std::string written(const CaseResult& result) const {
    write_report_html(result, result_charts(result), folder);
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
  result.impacts = {{.where = "moat left", .start = 3.25, .largest_force = 2.5e7}};
  result.solver.accepted_steps = 11'213;
  result.assumptions = {"Average acceleration."};
  for (const char* floor : {"base", "floor 5"})
    result.floor_spectra.push_back({.floor = floor, .spectrum = {0.05, {0.1, 1.0}, {}, {2.0, 1.0}, {}}});
  Table& table = result.histories;
  table.columns = {{"time", "", "s", {}},
                   {"displacement", "base", "m", {}},
                   {"displacement", "floor 1", "m", {}},
                   {"displacement", "floor 5", "m", {}},
                   {"absolute_acceleration", "base", "m/s^2", {}},
                   {"absolute_acceleration", "floor 5", "m/s^2", {}},
                   {"impact_force", "moat left", "N", {}},
                   {"isolator_deformation", "bearings", "m", {}},
                   {"isolator_force", "bearings", "N", {}}};
  for (int i = 0; i < 400; ++i) {
    table.columns[0].values.push_back(0.05 * i);
    for (std::size_t column = 1; column < table.columns.size(); ++column)
      table.columns[column].values.push_back(std::sin(0.1 * i + 0.3 * static_cast<double>(column)));
  }
  return result;
}

TEST_F(Report, HoldsEverythingItPromises) {
  const std::string html = written(example());
  EXPECT_NE(html.find("<title>Gap &lt; 10 cm &amp; &quot;hard&quot;</title>"), std::string::npos);
  for (const char* part : {"record A", "3.923 m/s²", "45.00 cm/s", "2.125 s", "12.35", "25650", "moat left", "11213",
                           "Average acceleration.", "<h2>Histories</h2>", "<h2>Isolators</h2>", "displacement [cm]",
                           "absolute acceleration [m/s²]", "impact force [kN]", "deformation [cm]",
                           "<h2>Floor response spectra</h2>", "floor 5"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("floor 1"), std::string::npos) << "only base and top are drawn";
  EXPECT_EQ(count(html, "<svg "), 5u) << "three histories, loops, spectra";
  EXPECT_EQ(count(html, "<table"), count(html, "</table>"));
}

TEST_F(Report, NamesItsOrigin) {
  CaseResult result = example();
  result.provenance = {"moat run tower.cpp --gap '20 cm'",
                       "/home/me/tower.cpp",
                       "c0ffee",
                       {{"gap", "20 cm"}},
                       "0.1.0",
                       "0123456789",
                       "2026-01-31T12:00:00Z"};
  result.analysis = {"Newmark's method", "located", "always", "never", {{"largest_step", 0.005, "s"}}};
  result.motion.components = {{"a", {"/records/a.AT2", "beef"}, 1.25}};
  result.motion.notes = {"PEER <header>"};
  result.model = {
      {{"base", 550e3, 0.0, 0.0, 0.02, 0.0}},
      {{"moat left", "gap", "HertzDamp", "base", "ground", {{"clearance", 0.1, "m"}, {"restitution", 0.65, "1"}}},
       {.name = "column",
        .kind = "gap",
        .law = "Hertz",
        .first = "base",
        .second = "floor 1",
        .parameters = {},
        .second_other = "floor 2",
        .second_share = 0.25}}};
  result.clearances = {{"moat left", 0.1, -0.01, 3.25}};
  const std::string html = written(result);
  for (const char* part : {"moat run tower.cpp --gap '20 cm'",
                           "/home/me/tower.cpp",
                           "c0ffee",
                           "--gap</td><td class=\"text\">20 cm",
                           "0.1.0, commit 0123456789",
                           "2026-01-31T12:00:00Z",
                           "/records/a.AT2",
                           "beef",
                           "1.25",
                           "PEER &lt;header&gt;",
                           "550000",
                           "HertzDamp",
                           "clearance 0.1 m, restitution 0.65",
                           "0.25 of the way from floor 1 to floor 2",
                           "Initial displacement [m]",
                           "Clearance left",
                           "-1.000",
                           "of 10 cm",
                           "Newmark's method",
                           "located",
                           "largest_step"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST_F(Report, ShowsPlacesInPlan) {
  CaseResult result = example();
  result.model = testing::plan_facts();
  const std::string page = written(result);
  for (const char* text : {"(1,\u00a02) to (1.5,\u00a02) along (0,\u00a01)", "<td>(3,\u00a04)</td>", "(0.5,\u00a00.25)",
                           "(0,\u00a00) (4,\u00a00) (4,\u00a03)", "floor corner 1", "(4.5,\u00a0-1)"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(Report, ShowsTheBeginningOfALongModel) {
  CaseResult result = example();
  for (int i = 0; i < 2000; ++i) result.model.nodes.push_back({"node " + std::to_string(i), 1.0, 0.0, 0.0});
  const std::string html = written(result);
  EXPECT_NE(html.find("2000 nodes"), std::string::npos);
  EXPECT_NE(html.find("... and 1900 more in summary.json"), std::string::npos);
  EXPECT_EQ(html.find("node 100<"), std::string::npos);
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
  for (const CaseResult& result : {testing_report::line_result(), testing_report::plan_result()}) {
    std::string html = written(result);
    // The name of the SVG language is not an address that is fetched.
    html = std::regex_replace(html, std::regex{R"re( xmlns="http://www\.w3\.org/2000/svg")re"}, "");
    // The library of charts stands between our style and our data, and has other words in its comments.
    if (const std::size_t library = html.rfind("<style>"), end = html.find("<script type=\"application/json\"");
        library > html.find("<body>") && library < end)
      html.erase(library, end - library);
    for (const char* reference : {"src=", "href=", "@import", "<link", "<iframe"})
      EXPECT_EQ(html.find(reference), std::string::npos) << reference;
    EXPECT_EQ(count(html, " id="), 2u) << "the data of the script and one button; ids of two charts would clash";
  }
}

TEST_F(Report, NamesCannotEndTheScript) {
  CaseResult result = testing_report::line_result();
  result.impacts[0].where = "</script><b>";
  const std::string html = written(result);
  EXPECT_EQ(html.find("</script><b>"), std::string::npos);
  EXPECT_NE(html.find("\\u003c/script>\\u003cb>"), std::string::npos);
}

TEST_F(Report, LeavesOutChartsWithoutColumns) {
  CaseResult result = example();
  result.histories.columns.pop_back();
  EXPECT_EQ(count(written(result), "<svg "), 4u);
  result.histories = {};
  result.floor_spectra.clear();
  result.impacts.clear();
  const std::string html = written(result);
  EXPECT_EQ(count(html, "<svg "), 0u);
  EXPECT_NE(html.find("No contact."), std::string::npos);
}

TEST_F(Report, ReportsAFolderThatIsMissing) {
  EXPECT_THROW(write_report_html(example(), {}, folder / "missing"), FileError);
}

}  // namespace
}  // namespace moat
