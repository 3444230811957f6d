// Heat maps.

#include "output/charts/heat_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

HeatMap map() {
  return {.title = "Drift <1>",
          .x_label = "gap [cm]",
          .y_label = "force [MN]",
          .value_label = "drift [cm]",
          .x_values = {"10", "20", "30"},
          .y_values = {"1", "2"},
          .values = {{1.0, 2.0, 3.0}, {4.0, std::nan(""), 5.0}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(HeatMap, HasACellForEveryValue) {
  const std::string svg = svg_text(map());
  // The ends of viridis, and grey for the value that is missing.
  EXPECT_GE(count(svg, "#440154"), 1u);
  EXPECT_GE(count(svg, "#fde725"), 1u);
  EXPECT_EQ(count(svg, "#c8c8c8"), 1u);
  for (const char* text : {">10<", ">30<", ">gap [cm]<", ">force [MN]<", ">drift [cm]<", "Drift &lt;1&gt;"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_NE(svg.find("drift [cm] over gap [cm] and force [MN], from 1 to 5."), std::string::npos);
}

TEST(HeatMap, OfOneValueCanBeDrawn) {
  HeatMap same = map();
  same.values = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  EXPECT_NO_THROW((void)svg_text(same));
}

TEST(HeatMap, WritesLargeNumbersWithoutExponent) {
  HeatMap large = map();
  large.values = {{60921.0, 1234.0, 0.5}, {-60921.0, 2.5e8, 999.0}};
  const std::string svg = svg_text(large);
  for (const char* number : {">60900<", ">1230<", ">0.5<", ">-60900<", ">2.5e+08<", ">999<"})
    EXPECT_NE(svg.find(number), std::string::npos) << number;
}

TEST(HeatMap, RefusesWhatDoesNotFit) {
  const auto refused = [](const HeatMap& wrong) {
    return testing::message_of<InputError>([&] { (void)svg_text(wrong); });
  };
  HeatMap wrong = map();
  wrong.values.pop_back();
  EXPECT_NE(refused(wrong).find("rows and of y_values differ"), std::string::npos);
  wrong = map();
  wrong.values[1].pop_back();
  EXPECT_NE(refused(wrong).find("columns and of x_values differ"), std::string::npos);
  wrong = map();
  wrong.values = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
  EXPECT_NE(refused(wrong).find("no value to draw"), std::string::npos);
  EXPECT_THROW((void)svg_text(map(), 100, 400), InputError);
}

}  // namespace
}  // namespace moat
