#include "design/sheet_page.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "design/asce_7_sheet.hpp"
#include "design/en_1998_sheet.hpp"
#include "in_folder.hpp"
#include "message_of.hpp"
#include "sheet_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

DesignSheet asce_7(const SheetBuilding& building = sheet_building()) {
  return Asce7Sheet{.building = building,
                    .spectrum = Asce7Spectrum{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s},
                    .s_1 = 0.6,
                    .response_modification = 5};
}

DesignSheet en_1998() {
  return En1998Sheet{.building = sheet_building(),
                     .spectrum = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The names of elements that are closed out of order, or not at all.
std::string badly_closed(const std::string& page) {
  static const std::regex tag{R"(<(/?)([a-z][a-z0-9]*)[^>]*>)"};
  std::vector<std::string> open;
  for (std::sregex_iterator each{page.begin(), page.end(), tag}, end; each != end; ++each) {
    const std::string name = (*each)[2];
    if (name == "meta" || name == "br") continue;
    if ((*each)[1].length() == 0)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return name;
    else
      open.pop_back();
  }
  return open.empty() ? "" : open.back();
}

TEST(SheetPage, SetsFormulas) {
  EXPECT_EQ(formula_as_html("D_TM"), "D<sub>TM</sub>");
  EXPECT_EQ(formula_as_html("4 pi^2 B_M"), "4 π<sup>2</sup> B<sub>M</sub>");
  EXPECT_EQ(formula_as_html("V_b (W_s/W)^(1 - 2.5 beta_M)"),
            "V<sub>b</sub> (W<sub>s</sub>/W)<sup>1 − 2.5 β<sub>M</sub></sup>");
  EXPECT_EQ(formula_as_html("D_TM,dyn >= 0.3 x gamma_x, xi <= eta"), "D<sub>TM,dyn</sub> ≥ 0.3 × γ<sub>x</sub>, ξ ≤ η");
  EXPECT_EQ(formula_as_html("sqrt(sum(x_i^2))"), "√(Σ(x<sub>i</sub><sup>2</sup>))");
  EXPECT_EQ(formula_as_html("a < b & c"), "a &lt; b &amp; c");
  EXPECT_EQ(formula_as_html("maximum, spirit, beta_M"), "maximum, spirit, β<sub>M</sub>") << "whole words";
}

TEST(SheetPage, IsWellFormedAndNeedsNothingElse) {
  const std::string page = sheet_page({asce_7(), en_1998()});
  EXPECT_EQ(badly_closed(page), "");
  EXPECT_EQ(count(page, "<section class=\"sheet\">"), 2u);
  EXPECT_EQ(page.find("://"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_NE(page.find("@page { size: A4"), std::string::npos);
  EXPECT_NE(page.find("<h2>Hospital: ASCE/SEI 7-16 and 7-22, chapter 17</h2>"), std::string::npos);
  EXPECT_NE(page.find("<h2>Hospital: EN 1998-1:2004, chapter 10, and EN 15129</h2>"), std::string::npos);
}

TEST(SheetPage, HasEveryLineAndEveryGivenNumber) {
  for (const DesignSheet& sheet : {asce_7(), en_1998()}) {
    const std::string page = sheet_page({sheet});
    std::size_t at = page.find("<table>");
    for (const SheetLine& line : sheet.lines) {
      at = page.find("<tr><td>" + formula_as_html(line.symbol) + "</td>", at);
      ASSERT_NE(at, std::string::npos) << line.symbol;
      const std::string row = page.substr(at, page.find("</tr>", at) - at);
      EXPECT_NE(row.find("<td>" + formula_as_html(line.numbers) + "</td>"), std::string::npos) << row;
      for (const double value : line.values) {
        const std::string number = sheet_value(value, line.unit);
        EXPECT_NE(row.find(">" + number.substr(0, number.find(' ')) + "<"), std::string::npos) << row;
      }
      EXPECT_EQ(count(row, "<strong>"), line.governs ? 1u : 0u) << row;
    }
    for (const GivenValue& each : sheet.given)
      EXPECT_NE(page.find("<span>" + formula_as_html(each.symbol) + " = " + sheet_value(each.value, each.unit)),
                std::string::npos)
          << each.symbol;
    for (const std::string& note : sheet.notes) EXPECT_NE(page.find(formula_as_html(note)), std::string::npos);
  }
}

TEST(SheetPage, BeginsWithTheVerdict) {
  const std::string page = sheet_page({asce_7()});
  const std::size_t box = page.find("<div class=\"verdict broken\">");
  ASSERT_NE(box, std::string::npos);
  EXPECT_LT(box, page.find("<table>"));
  EXPECT_EQ(page.find("<strong>clearance 0.45 m &lt; D<sub>TM</sub> 0.5717 m (lower bounds)</strong>", box),
            box + std::string{"<div class=\"verdict broken\">"}.size());
  EXPECT_NE(page.find("<td><span class=\"broken\">not kept</span></td>"), std::string::npos);
  SheetBuilding wide = sheet_building();
  wide.clearance = 0.6 * m;
  const std::string kept = sheet_page({asce_7(wide)});
  EXPECT_NE(kept.find("<div class=\"verdict\"><strong>clearance 0.6 m ≥ D<sub>TM</sub> 0.5717 m (lower bounds)</strong>"
                      "<br>2 other rules are kept.</div>"),
            std::string::npos);
  EXPECT_EQ(kept.find("not kept</span>"), std::string::npos);
}

TEST(SheetPage, MarksClausesFromMemory) {
  const DesignSheet sheet = asce_7();
  const std::string page = sheet_page({sheet});
  const auto recalled = std::ranges::count(sheet.lines, ClauseSource::recalled, &SheetLine::source);
  EXPECT_EQ(count(page, "<span class=\"recalled\">recalled, not read</span>"), static_cast<std::size_t>(recalled));
  EXPECT_NE(page.find("<td>17.2.8.4 <span class=\"recalled\">recalled, not read</span></td>"), std::string::npos);
  EXPECT_NE(page.find("<td>17.5.4.1</td>"), std::string::npos);
}

TEST(SheetPage, ShowsADashWhereACaseWasNotComputed) {
  SheetBuilding building = sheet_building();
  building.suite = {
      .statistic = "mean of 7 <records>", .lower = {.base_shear = 7.5 * MN}, .upper = {.base_shear = 8 * MN}};
  const std::string page = sheet_page({asce_7(building)});
  EXPECT_NE(page.find("<td>mean of 7 &lt;records&gt;</td><td class=\"number\">7500</td><td class=\"number\">-</td>"),
            std::string::npos);
  EXPECT_EQ(badly_closed(page), "");
}

// A result that impacts may have made large enough stands in the box, and is no kept rule.
TEST(SheetPage, SaysWhatIsNotJudged) {
  SheetBuilding building = sheet_building();
  building.clearance = 0.6 * m;
  building.suite = {.statistic = "mean of 7 records",
                    .lower = {.base_shear = 9 * MN, .touching = 3},
                    .upper = {.base_shear = 9 * MN},
                    .base_shear_has_impacts = true};
  const std::string page = sheet_page({asce_7(building)});
  EXPECT_NE(page.find("<div class=\"verdict\"><strong>clearance 0.6 m ≥ D<sub>TM</sub> 0.5717 m (lower bounds), not "
                      "judged: 3 records touch; repeat the histories with a gap that stays open</strong><br>"
                      "V<sub>b,dyn</sub> 9000 kN (upper bounds) ≥ 7490 kN, not judged: 3 records touch"),
            std::string::npos);
  EXPECT_NE(page.find("<br>2 other rules are kept.</div>"), std::string::npos);
  EXPECT_EQ(count(page, "<td>not judged</td>"), 3u) << "gap, V_b,dyn and V_above";
}

using SheetFile = InFolder;

TEST_F(SheetFile, IsWritten) {
  write_design_sheets({asce_7()}, folder / "design_sheet.html");
  std::ifstream file{folder / "design_sheet.html"};
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>{file}, {}}), sheet_page({asce_7()}));
  EXPECT_NE(message_of<FileError>([&] { write_design_sheets({asce_7()}, folder / "none/sheet.html"); }).find("none"),
            std::string::npos);
}

}  // namespace
}  // namespace moat::testing
