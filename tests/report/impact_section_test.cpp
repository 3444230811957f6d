#include "report/sections.hpp"

#include <gtest/gtest.h>

#include "report/charts/result_charts.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::count;

Impact impact_of(std::string where, double start, double force) {
  Impact impact{.where = std::move(where), .start = start, .largest_force = force};
  impact.loop = {{0.0, 0.01, 0.0}, {0.0, force, 0.0}};
  return impact;
}

TEST(ImpactSection, ExplainsEveryColumn) {
  CaseResult result;
  result.impacts = {impact_of("moat left", 3.25, 2.5e7)};
  const std::string html = html::impact_section(result, {});
  EXPECT_EQ(count(html, " title=\""), 8u);
  EXPECT_NE(html.find("<li>Rebound ratio: Speed of separation over speed of approach"), std::string::npos);
  EXPECT_NE(html.find("data-time=\"3.25\""), std::string::npos);
}

TEST(ImpactSection, CutsNoTitleOfALoop) {
  CaseResult result;
  result.impacts = {impact_of("moat wall 2 corner 3", 3.25, 2.5e7)};
  const std::string html = html::impact_section(result, impact_loops(result.impacts));
  EXPECT_NE(html.find(">3.250 s, moat wall 2 corner 3</text>"), std::string::npos);
}

TEST(ImpactSection, SeparatesImpactsMillisecondsApart) {
  CaseResult result;
  result.impacts = {impact_of("a", 12.5512, 1.0), impact_of("a", 12.5538, 1.0)};
  const std::string html = html::impact_section(result, {});
  EXPECT_NE(html.find(">12.5512<"), std::string::npos);
  EXPECT_NE(html.find(">12.5538<"), std::string::npos);
}

TEST(ImpactSection, ShowsTheRestitutionAskedAndDelivered) {
  CaseResult result;
  result.impacts = {impact_of("moat left", 3.25, 2.5e7)};
  result.impacts[0].restitution = 0.7748;
  result.impacts[0].rebound_ratio = 0.5;
  result.model.elements = {{"moat left", "gap", "HertzDamp", "base", "ground", {{"restitution", 0.65, "1"}}}};
  const std::string html = html::impact_section(result, impact_loops(result.impacts));
  EXPECT_EQ(count(html, "<svg "), 1u);
  EXPECT_NE(html.find("3.250 s, moat left</td><td class=\"number\">0.65</td><td class=\"number\">0.7748</td><td "
                      "class=\"number\">0.5</td>"),
            std::string::npos);
}

TEST(ImpactSection, ShowsTheBeginningOfALongTable) {
  CaseResult result;
  for (int i = 0; i < 130; ++i) result.impacts.push_back(impact_of("gap", 0.1 * i, 1.0));
  const std::string html = html::impact_section(result, {});
  EXPECT_EQ(count(html, "data-time="), html::most_impacts);
  EXPECT_NE(html.find("30 more in impacts.csv"), std::string::npos);
}

TEST(ImpactSection, SaysWhereThereIsNoContact) {
  EXPECT_NE(html::impact_section({}, {}).find("No contact."), std::string::npos);
}

TEST(ImpactLoops, AreTheStrongestInOrderOfTime) {
  std::vector<Impact> impacts;
  for (int i = 0; i < 20; ++i) impacts.push_back(impact_of("gap", i, i < 15 ? 100.0 - i : 1000.0));
  const std::vector<Chart> loops = impact_loops(impacts);
  ASSERT_EQ(loops.size(), most_impact_loops);
  EXPECT_EQ(loops.front().title, "0.000 s, gap");
  EXPECT_EQ(loops[6].title, "6.000 s, gap");
  EXPECT_EQ(loops[7].title, "15.000 s, gap");
  EXPECT_EQ(loops.back().title, "19.000 s, gap");
}

TEST(ImpactLoops, EncloseTheEnergyLost) {
  const CaseResult result = testing_report::line_result();
  ASSERT_FALSE(result.impacts.empty());
  for (const Impact& impact : result.impacts) {
    double area = 0.0;
    for (std::size_t i = 1; i < impact.loop.force.size(); ++i)
      area += 0.5 * (impact.loop.force[i] + impact.loop.force[i - 1]) *
              (impact.loop.indentation[i] - impact.loop.indentation[i - 1]);
    EXPECT_NEAR(area, impact.energy_lost, 0.01 * impact.energy_lost) << impact.start;
    EXPECT_EQ(impact.loop.force.back(), 0.0);
  }
}

}  // namespace
}  // namespace moat
