// Tornado charts.

#include "output/charts/tornado.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

Tornado chart() {
  return {
      .title = "Force <1>",
      .value_label = "impact force [kN]",
      .nominal = 100.0,
      .error = 5.0,
      .bars = {{"k/3", "3k", 80.0, 180.0}, {"e-.1", "e+.1", 104.0, 102.0}, {"gap-10%", "gap+10%", 90.0, std::nan("")}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Tornado, LabelsBothEndsOfEveryBar) {
  const std::string svg = svg_text(chart());
  for (const char* label : {">k/3<", ">3k<", ">e-.1<", ">e+.1<", ">gap-10%<", "Force &lt;1&gt;", ">impact force [kN]<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  EXPECT_EQ(svg.find(">gap+10%<"), std::string::npos) << "its value is not known";
  EXPECT_NE(svg.find("impact force [kN], nominal 100, k/3 80, 3k 180, e+.1 102, e-.1 104, gap-10% 90."),
            std::string::npos)
      << svg;
}

TEST(Tornado, FillsTheEndWhereTheParameterIncreases) {
  const std::string svg = svg_text(chart());
  // Five discs, of which the three open ones have a disc of paper inside.
  EXPECT_EQ(count(svg, "<circle"), 5u + 3u);
  EXPECT_EQ(count(svg, "<circle class=\"chart-paper\""), 3u);
  // e+.1 is filled and stands left of e-.1, because both lie on one side.
  EXPECT_LT(svg.find(">e+.1<"), svg.find(">e-.1<"));
}

TEST(Tornado, ShowsTheNumericalErrorWhereItIsKnown) {
  // Nominal value, error and its two ends besides the lines of the grid.
  Tornado without = chart();
  without.error = std::nan("");
  EXPECT_EQ(count(svg_text(chart()), "<polyline"), count(svg_text(without), "<polyline") + 3u);
}

TEST(Tornado, OfOneValueCanBeDrawn) {
  Tornado same = chart();
  same.nominal = 0.0;
  same.error = 0.0;
  same.bars = {{"k/3", "3k", 0.0, 0.0}};
  EXPECT_NO_THROW((void)svg_text(same));
  same.bars = {{"k/3", "3k", std::nan(""), std::nan("")}};
  EXPECT_NO_THROW((void)svg_text(same));
}

TEST(Tornado, HasItsNumbersAsATable) {
  const Table table = table_of(chart());
  ASSERT_EQ(table.columns.size(), 8u);
  EXPECT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.values("nominal"), std::vector<double>{100.0});
  EXPECT_EQ(table.values("error"), std::vector<double>{5.0});
  EXPECT_EQ(table.values("3k"), std::vector<double>{180.0});
  for (const Column& column : table.columns) EXPECT_EQ(column.unit, "kN");
}

TEST(Tornado, RefusesWhatCannotBeDrawn) {
  const auto refused = [](const Tornado& wrong, int width = 500) {
    return testing::message_of<InputError>([&] { (void)svg_text(wrong, width); });
  };
  EXPECT_NE(refused(chart(), 200).find("width = 200 pixels"), std::string::npos);
  Tornado wrong = chart();
  wrong.nominal = std::numeric_limits<double>::infinity();
  EXPECT_NE(refused(wrong).find("nominal"), std::string::npos);
  wrong = chart();
  wrong.bars.clear();
  EXPECT_EQ(refused(wrong), "Tornado \"Force <1>\": there are no bars. Give at least one.");
}

}  // namespace
}  // namespace moat
