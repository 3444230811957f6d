// The section on contact parameters, and its charts.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "report/charts/result_charts.hpp"
#include "report/sections.hpp"
#include "report_testing.hpp"

namespace moat {
namespace {

using testing_report::count;

ContactSensitivity example() {
  return {.computed = true,
          .rigid_walls = true,
          .impacts = 7,
          .changes = {{.parameter = "stiffness", .factor = 1.0 / 3.0, .impacts = 8},
                      {.parameter = "stiffness", .factor = 3.0, .impacts = 6},
                      {.parameter = "restitution", .difference = -0.1, .impacts = 7},
                      {.parameter = "restitution", .difference = 0.1, .impacts = 7},
                      {.parameter = "clearance", .factor = 0.9, .failure = "it <failed>."}},
          .peaks = {{"displacement", "base", "m", -0.16, 1e-3, {-0.21, -0.13, -0.15, -0.18, std::nan("")}},
                    {"displacement", "floor 1", "m", 0.1, 1e-3, {0.2, 0.2, 0.2, 0.2, std::nan("")}},
                    {"velocity", "base", "m/s", 1.0, 1e-3, {1.0, 1.0, 1.0, 1.0, std::nan("")}},
                    {"absolute_acceleration", "base", "m/s^2", 54.0, 1e-3, {50.0, 55.0, 30.0, 54.0, std::nan("")}}}};
}

TEST(SensitivityCharts, AreOneForEachOfTheLargestPeaks) {
  const std::vector<Tornado> charts = sensitivity_charts(example());
  ASSERT_EQ(charts.size(), 2u) << "velocities are not compared";
  EXPECT_EQ(charts[0].title, "If contact differs: displacement, base");
  EXPECT_EQ(charts[0].value_label, "displacement [cm]");
  EXPECT_DOUBLE_EQ(charts[0].nominal, 16.0);
  EXPECT_DOUBLE_EQ(charts[0].error, 0.1);
  ASSERT_EQ(charts[0].bars.size(), 3u);
  EXPECT_EQ(charts[0].bars[0].decrease, "k/3");
  EXPECT_EQ(charts[0].bars[0].increase, "3k");
  EXPECT_DOUBLE_EQ(charts[0].bars[0].decreased, 21.0);
  EXPECT_DOUBLE_EQ(charts[0].bars[0].increased, 13.0);
  EXPECT_TRUE(std::isnan(charts[0].bars[2].decreased)) << "that run failed";
  EXPECT_EQ(charts[1].bars[0].decrease, "e-.1") << "it moves the acceleration most";
  EXPECT_TRUE(sensitivity_charts({}).empty());
}

TEST(SensitivitySection, ShowsChartsImpactsAndNotes) {
  const ContactSensitivity sensitivity = example();
  const std::string html = html::sensitivity_section(sensitivity, sensitivity_charts(sensitivity));
  EXPECT_EQ(count(html, "<svg"), 2u);
  EXPECT_NE(html.find("One at a time; no probability; combinations may exceed it."), std::string::npos);
  EXPECT_NE(html.find("numerical error"), std::string::npos);
  EXPECT_NE(html.find("<p>Impacts: 7; k/3 8; 3k 6; e-.1 7; e+.1 7.</p>"), std::string::npos) << html;
  EXPECT_NE(html.find("<li>gap-10%: no results, it &lt;failed&gt;.</li>"), std::string::npos) << html;
  EXPECT_NE(html.find("<li>Rigid walls: a wall that gives way changes this more than k.</li>"), std::string::npos);
}

TEST(SensitivitySection, SaysWhyThereAreNoRuns) {
  EXPECT_EQ(html::sensitivity_section({}, {}), "") << "a model without contacts";
  EXPECT_EQ(html::sensitivity_section({.reason = "It was not wanted."}, {}), "");
  const std::string left_out = html::sensitivity_section({.reason = "Too long.", .runs_left_out = 6}, {});
  EXPECT_NE(left_out.find("<li>Too long.</li>"), std::string::npos) << left_out;
  const std::string far = html::sensitivity_section({.computed = true, .reason = "No contact."}, {});
  EXPECT_NE(far.find("<li>No contact.</li>"), std::string::npos) << far;
  EXPECT_EQ(far.find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace moat
