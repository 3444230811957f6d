#include "report/html.hpp"

#include <gtest/gtest.h>

#include "report_testing.hpp"

namespace moat {
namespace {

TEST(ChartGrid, MakesAPictureOfEachChart) {
  const Chart chart{.title = "A", .x_label = "gap [cm]", .y_label = "1", .series = {{"", {0.0, 1.0}, {0.0, 1.0}}}};
  const std::string html = html::chart_grid({chart, chart}, 500, 300);
  EXPECT_EQ(html.find("<div class=\"charts\" style=\"--width: 500px\">"), 0u) << html;
  EXPECT_EQ(testing_report::count(html, "<svg "), 2u);
  EXPECT_EQ(testing_report::count(html, "width=\"500\" height=\"300\" viewBox"), 2u) << html;
}

}  // namespace
}  // namespace moat
