#include "output/charts/chart.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <locale>
#include <set>
#include <sstream>

#include "output_testing.hpp"

namespace moat {
namespace {

using testing_output::message_of;
using testing_output::parse_xml;
using testing_output::read_file;

class ChartToSvg : public testing_output::InFolder {};

void visit(vtkXMLDataElement* element, const std::function<void(vtkXMLDataElement*)>& action) {
  action(element);
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i) visit(element->GetNestedElement(i), action);
}

std::set<std::string> texts_of(vtkXMLDataElement* root) {
  std::set<std::string> texts;
  visit(root, [&](vtkXMLDataElement* element) {
    if (std::string{element->GetName()} != "text") return;
    std::string text = element->GetCharacterData();
    text.erase(0, text.find_first_not_of(" \n"));
    text.erase(text.find_last_not_of(" \n") + 1);
    texts.insert(text);
  });
  return texts;
}

/// Numbers as in Germany, for streams that do not choose their locale.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

using Curve = std::vector<std::pair<double, double>>;

/// The pixels of the curves drawn with a stroke colour.
std::vector<Curve> curves_of(vtkXMLDataElement* root, const std::string& colour) {
  std::vector<Curve> curves;
  visit(root, [&](vtkXMLDataElement* element) {
    const char* stroke = element->GetAttribute("stroke");
    const char* points = element->GetAttribute("points");
    if (stroke == nullptr || points == nullptr || stroke != colour) return;
    std::istringstream stream{points};
    char comma = ' ';
    curves.emplace_back();
    for (double x = 0.0, y = 0.0; stream >> x >> comma >> y;) curves.back().emplace_back(x, y);
  });
  return curves;
}

/// The one with most points.
Curve curve_of(vtkXMLDataElement* root, const std::string& colour) {
  Curve longest;
  for (const Curve& curve : curves_of(root, colour))
    if (curve.size() > longest.size()) longest = curve;
  return longest;
}

Chart sine() {
  Chart chart{.title = "Base & <top>", .x_label = "time [s]", .y_label = "displacement [cm]", .series = {}};
  Series base{.name = "base", .x = {}, .y = {}};
  Series record{.name = "record", .x = {1.0, 2.0}, .y = {0.5, -0.5}, .style = Series::Style::markers};
  for (int i = 0; i <= 50'000; ++i) {
    base.x.push_back(0.0004 * i);
    base.y.push_back(std::sin(base.x.back()));
  }
  base.y[12'345] = 10.0;
  chart.series = {base, record};
  return chart;
}

TEST_F(ChartToSvg, IsWellFormedAndHoldsItsLabels) {
  write_svg(sine(), folder / "chart.svg", 900, 400);
  const auto root = parse_xml(read_file(folder / "chart.svg"));
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetName(), "svg");
  EXPECT_STREQ(root->GetAttribute("width"), "900");
  EXPECT_STREQ(root->GetAttribute("height"), "400");
  const std::set<std::string> texts = texts_of(root);
  for (const char* label : {"Base & <top>", "time [s]", "displacement [cm]", "base", "record", "0", "10", "20"})
    EXPECT_TRUE(texts.contains(label)) << label;
}

TEST_F(ChartToSvg, IsDescribedForReadersWhoDoNotSeeIt) {
  Chart chart{.title = "Drift", .x_label = "time [s]", .y_label = "drift [cm]", .series = {}};
  chart.series = {{.name = "storey 1", .x = {0, 1}, .y = {-1.5, 2}}, {.name = "", .x = {0, 1}, .y = {3, 45231}}};
  Chart other = chart;
  other.title = "Other";
  other.series.pop_back();
  const auto root = parse_xml(svg_text({chart, other}));
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetAttribute("role"), "img");
  EXPECT_STREQ(root->FindNestedElementWithName("title")->GetCharacterData(), "Drift; Other");
  EXPECT_STREQ(root->FindNestedElementWithName("desc")->GetCharacterData(),
               "Drift: drift [cm] over time [s]; storey 1 from -1.5 to 2, from 3 to 45231. "
               "Other: drift [cm] over time [s]; storey 1 from -1.5 to 2.");
}

TEST_F(ChartToSvg, DrawsASinglePointOfALine) {
  const Chart chart{.title = "a", .x_label = "x", .y_label = "y", .series = {{.name = "", .x = {1}, .y = {2}}}};
  EXPECT_NE(svg_text({chart}).find("<circle"), std::string::npos);
}

TEST_F(ChartToSvg, PlacesChartsInColumnsWithAlignedPlotAreas) {
  const Chart line{.title = "a", .x_label = "x", .y_label = "y", .series = {{.name = "l", .x = {0, 1}, .y = {0, 1}}}};
  Chart with_long_legend = line;
  for (int i = 0; i < 6; ++i)
    with_long_legend.series.push_back({.name = "a rather long name", .x = {0, 1}, .y = {1, 0}});
  write_svg({line, with_long_legend, line}, folder / "chart.svg", 1000, 300, 2);
  const auto root = parse_xml(read_file(folder / "chart.svg"));
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetAttribute("width"), "1000");
  // The line of every panel rises from its lower left to its upper right corner.
  std::vector<Curve> lines = curves_of(root, "#0072b2");
  std::erase_if(lines, [](const auto& each) { return each.size() < 2 || each[0].second == each[1].second; });
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_LT(lines[0][1].first, 500.0);
  EXPECT_NEAR(lines[1][0].first, lines[0][0].first + 500.0, 0.06);
  EXPECT_NEAR(lines[1][0].second, lines[0][0].second, 0.06) << "plot areas of one row";
  EXPECT_NEAR(lines[1][1].second, lines[0][1].second, 0.06) << "plot areas of one row";
  EXPECT_NEAR(lines[2][0].first, lines[0][0].first, 0.06) << "plot areas of one column";
  EXPECT_GT(lines[2][1].second, lines[0][0].second) << "the second row is below the first";
}

TEST_F(ChartToSvg, StartsAtZeroWhereAsked) {
  Chart chart{.title = "a", .x_label = "x", .y_label = "y", .series = {{.name = "l", .x = {0, 1}, .y = {100, 101}}}};
  chart.y_from_zero = true;
  const auto curve = curve_of(parse_xml(svg_text({chart})), "#0072b2");
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_LT(std::abs(curve[1].second - curve[0].second), 5.0) << "1 % of the axis";
  chart.series[0].y[0] = -1.0;
  EXPECT_NE(message_of<InputError>([&] { svg_text({chart}); }).find("The y axis starts from zero."), std::string::npos);
}

TEST_F(ChartToSvg, GivesASeriesTheColourItAsksFor) {
  Chart chart{.title = "a", .x_label = "x", .y_label = "y", .series = {}};
  chart.series = {{.name = "", .x = {0, 1}, .y = {0, 1}}, {.name = "", .x = {0, 1}, .y = {1, 0}, .colour = 2}};
  const auto root = parse_xml(svg_text({chart}));
  EXPECT_EQ(curve_of(root, "#0072b2").size(), 2u);
  EXPECT_EQ(curve_of(root, "#009e73").size(), 2u) << "third of the palette";
  EXPECT_EQ(curve_of(root, "#d55e00").size(), 0u) << "second of the palette";
}

TEST_F(ChartToSvg, ThinsLongSeriesButKeepsThePeak) {
  write_svg(sine(), folder / "chart.svg", 900, 400);
  EXPECT_LT(std::filesystem::file_size(folder / "chart.svg"), 60'000u);
  const auto root = parse_xml(read_file(folder / "chart.svg"));
  const auto curve = curve_of(root, "#0072b2");
  ASSERT_GT(curve.size(), 900u);
  EXPECT_LE(curve.size(), 2u * 900u);
  const auto highest =
      std::min_element(curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  // x runs over 20 s, of which the peak is at 4.938 s; pixels count downwards.
  const double along = (highest->first - curve.front().first) / (curve.back().first - curve.front().first);
  EXPECT_NEAR(along, 4.938 / 20.0, 1.0 / 700.0);
  int above_peak = 0;
  for (const auto& [x, y] : curve) above_peak += y <= highest->second + 50.0 ? 1 : 0;
  EXPECT_EQ(above_peak, 1) << "one spike, ten times higher than the rest";
}

TEST_F(ChartToSvg, MapsALogarithmicAxisByDecades) {
  Chart chart{.title = "Spectrum", .x_label = "period [s]", .y_label = "acceleration [m/s^2]", .series = {}};
  chart.series.push_back({.name = "record", .x = {0.01, 0.1, 1.0, 10.0}, .y = {1.0, 2.0, 3.0, 4.0}});
  chart.logarithmic_x = true;
  const auto root = parse_xml(svg_text({chart}));
  ASSERT_NE(root, nullptr);
  const auto curve = curve_of(root, "#0072b2");
  ASSERT_EQ(curve.size(), 4u);
  const double decade = (curve[3].first - curve[0].first) / 3.0;
  EXPECT_GT(decade, 100.0);
  // Pixels are rounded to a twentieth.
  EXPECT_NEAR(curve[1].first, curve[0].first + decade, 0.1);
  EXPECT_NEAR(curve[2].first, curve[0].first + 2.0 * decade, 0.1);
  const std::set<std::string> texts = texts_of(root);
  for (const char* label : {"0.01", "0.1", "1", "10"}) EXPECT_TRUE(texts.contains(label)) << label;
}

TEST_F(ChartToSvg, GivesALongLegendRowsOfItsOwn) {
  Chart chart{.title = "Many", .x_label = "x [1]", .y_label = "y [1]", .series = {}};
  for (int i = 0; i < 20; ++i)
    chart.series.push_back({.name = "a rather long name " + std::to_string(i), .x = {0.0, 1.0}, .y = {0.0, 1.0 + i}});
  const auto root = parse_xml(svg_text({chart}, 800, 300));
  ASSERT_NE(root, nullptr);
  EXPECT_GT(std::stoi(root->GetAttribute("height")), 300);
  EXPECT_TRUE(texts_of(root).contains("a rather long name 19"));
}

// Sums of widths are rounded: the last entry must not go to a row below the title for that.
TEST_F(ChartToSvg, HasItsLegendBesideTheTitleOrInRowsOfItsOwn) {
  Chart chart{.title = "Incremental dynamic analysis", .x_label = "x", .y_label = "y", .series = {}};
  for (const char* name : {"16 %", "median of 12 records", "84 %"})
    chart.series.push_back({.name = name, .x = {0, 1}, .y = {0, 1}});
  int beside = 0, below = 0;
  for (int width = 400; width < 1200; width += 7) {
    const auto root = parse_xml(svg_text({chart}, width, 300));
    const bool in_title_row = std::stoi(root->GetAttribute("height")) == 300;
    (in_title_row ? beside : below) += 1;
    visit(root, [&](vtkXMLDataElement* element) {
      const char *size = element->GetAttribute("font-size"), *anchor = element->GetAttribute("text-anchor");
      if (size == nullptr || std::string{size} != "14" || std::string{anchor} != "start") return;
      EXPECT_EQ(std::stod(element->GetAttribute("y")) < 40.0, in_title_row) << width << element->GetCharacterData();
    });
  }
  EXPECT_GT(beside, 0);
  EXPECT_GT(below, 0);
}

TEST_F(ChartToSvg, LeavesOutWhatIsOutsideTheRange) {
  Chart chart = sine();
  chart.x_range = std::pair{5.0, 10.0};
  const auto root = parse_xml(svg_text({chart}, 900, 400));
  ASSERT_NE(root, nullptr);
  for (const auto& [x, y] : curve_of(root, "#0072b2")) {
    EXPECT_GE(x, 0.0);
    EXPECT_LE(x, 900.0);
  }
  EXPECT_TRUE(texts_of(root).contains("5.0"));
  EXPECT_TRUE(texts_of(root).contains("10.0"));
  for (const char* outside : {"4.5", "10.5", "20", "20.0"}) EXPECT_FALSE(texts_of(root).contains(outside)) << outside;
}

TEST_F(ChartToSvg, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(svg_text(std::vector<Chart>{}), InputError);
  EXPECT_EQ(message_of<InputError>([&] { svg_text({sine()}, 100, 400); }),
            "Chart \"" + sine().title +
                "\": width = 100 pixels is not allowed; it must be >= 200 pixels for every "
                "column. Check its sign and its unit.");
  EXPECT_THROW(svg_text({Chart{.title = "empty", .x_label = "", .y_label = "", .series = {}}}), InputError);
  Chart chart = sine();
  chart.series[1].y.pop_back();
  EXPECT_EQ(message_of<InputError>([&] { svg_text({chart}); }),
            "Series \"record\": x and y have different lengths. Give one y for every x.");
  chart = sine();
  chart.series[1].y[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(svg_text({chart}), InputError);
  chart = sine();
  chart.logarithmic_x = true;  // the first time is zero
  EXPECT_THROW(svg_text({chart}), InputError);
  chart = sine();
  chart.x_range = std::pair{2.0, 1.0};
  EXPECT_THROW(svg_text({chart}), InputError);
  EXPECT_THROW(write_svg(sine(), folder / "missing" / "chart.svg"), FileError);
}

TEST_F(ChartToSvg, DoesNotFollowTheLocaleOfTheProgram) {
  const std::string expected = svg_text({sine()});
  const std::locale before = std::locale::global(std::locale{std::locale::classic(), new Comma});
  const std::string text = svg_text({sine()});
  EXPECT_EQ(std::locale{}.name(), "*") << "the program keeps its locale";
  std::locale::global(before);
  EXPECT_EQ(text, expected);
}

// 4.903325 m/s^2 are 0.5 g.
TEST(Chart, HasASecondScaleOnTheOtherSide) {
  Chart chart{.title = "Acceleration",
              .x_label = "time [s]",
              .y_label = "acceleration [m/s^2]",
              .series = {{.name = "roof", .x = {0.0, 1.0}, .y = {0.0, 4.903325}}},
              .y_from_zero = true};
  const std::string plain = svg_text({chart});
  EXPECT_EQ(plain.find(" g</text>"), std::string::npos);
  chart.second_unit = SecondUnit{.symbol = "g", .per_first = 1.0 / 9.80665};
  const std::string beside = svg_text({chart});
  EXPECT_NE(beside.find(">0.50 g</text>"), std::string::npos) << beside;
  std::swap(chart.series[0].x, chart.series[0].y);
  chart.second_unit->of_x = true;
  const std::string above = svg_text({chart});
  EXPECT_NE(above.find(">0.50 g</text>"), std::string::npos) << above;
}

// Fields that are left out are empty, without a warning of the compiler.
TEST(Chart, NeedsTheFieldsThatMatterAlone) {
  const Chart chart{.title = "Empty", .x_label = "x"};
  const Series series{.name = "none"};
  EXPECT_TRUE(chart.series.empty());
  EXPECT_TRUE(series.x.empty());
}

}  // namespace
}  // namespace moat
