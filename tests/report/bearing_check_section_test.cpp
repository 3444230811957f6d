#include <gtest/gtest.h>

#include "report/sections.hpp"

namespace moat {
namespace {

TEST(BearingCheckSection, ShowsTheWorstBearingOfEveryTypeAndMarksRatiosAboveOne) {
  CaseResult result;
  EXPECT_EQ(html::bearing_check_section(result), "");
  const auto displaced = [](double demand) {
    return BearingDemand{
        .check = "displacement", .unit = "m", .demand = demand, .capacity = 0.5, .source = "given", .time = 4.5};
  };
  const BearingDemand not_judged{
      .check = "tension", .unit = "N", .demand = 1e5, .source = "not judged: no tension_capacity"};
  result.bearing_checks = {{"bearing 1", "LRB", displaced(0.25)},
                           {"bearing 1", "LRB", not_judged},
                           {"bearing 2", "LRB", displaced(0.4)},
                           {"bearing 3", "FPS", displaced(0.6)}};
  const std::string html = html::bearing_check_section(result);
  EXPECT_EQ(html.find("<td class=\"number\">25</td>"), std::string::npos) << "the first bearing";
  EXPECT_NE(html.find("<tr><td>LRB</td><td>Displacement</td><td>bearing 2</td><td class=\"number\">40</td><td "
                      "class=\"number\">50</td><td>cm</td><td class=\"number\">0.8</td><td class=\"number\">4.500"
                      "</td><td>given</td></tr>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("<td class=\"number\">100</td><td class=\"number\">-</td><td>kN</td>"), std::string::npos)
      << html;
  EXPECT_NE(html.find("not judged: no tension_capacity"), std::string::npos);
  const std::size_t exceeded = html.find("<tr class=\"unsettled\">");
  EXPECT_EQ(html.find("<tr class=\"unsettled\"><td>FPS</td>"), exceeded);
  EXPECT_EQ(html.find("<tr class=\"unsettled\">", exceeded + 1), std::string::npos);
}

}  // namespace
}  // namespace moat
