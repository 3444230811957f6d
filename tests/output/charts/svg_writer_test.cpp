#include "output/charts/svg_writer.hpp"

#include <limits>

#include "output_testing.hpp"

namespace moat {
namespace {

using testing_output::parse_xml;

vtkXMLDataElement* drawing_in(vtkXMLDataElement* root) { return root->FindNestedElementWithName("g"); }

TEST(SvgWriter, SaysWhatIsSeen) {
  const auto root = parse_xml(SvgWriter(300, 200, "A & B", "two < three").finish());
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetAttribute("role"), "img");
  EXPECT_STREQ(root->GetAttribute("viewBox"), "0 0 300 200");
  EXPECT_STREQ(root->GetNestedElement(0)->GetName(), "title") << "viewers show the first one";
  EXPECT_STREQ(root->FindNestedElementWithName("title")->GetCharacterData(), "A & B");
  EXPECT_STREQ(root->FindNestedElementWithName("desc")->GetCharacterData(), "two < three");
}

TEST(SvgWriter, RoundsToATwentiethOfAPixel) {
  SvgWriter svg{300, 200, "", ""};
  svg.line({{1.0, 2.52}, {-0.3, 10.349}, {-1.26, 0.01}, {7.05, 99.999}}, {"#123456"});
  const auto root = parse_xml(svg.finish());
  ASSERT_NE(root, nullptr);
  vtkXMLDataElement* line = drawing_in(root)->GetNestedElement(0);
  EXPECT_STREQ(line->GetAttribute("points"), "1,2.5 -0.3,10.35 -1.25,0 7.05,100");
}

TEST(SvgWriter, DrawsNothingFartherThanAMillionPixels) {
  SvgWriter svg{300, 200, "", ""};
  const double infinite = std::numeric_limits<double>::infinity();
  svg.line({{1.0, std::numeric_limits<double>::quiet_NaN()}, {infinite, -infinite}, {1e300, -1e9}}, {"#123456"});
  const auto root = parse_xml(svg.finish());
  ASSERT_NE(root, nullptr);
  vtkXMLDataElement* line = drawing_in(root)->GetNestedElement(0);
  EXPECT_STREQ(line->GetAttribute("points"), "1,0 0,0 1000000,-1000000");
}

TEST(SvgWriter, IsWellFormedWhateverTheTexts) {
  SvgWriter svg{300, 200, "a\x01", "b\xFF"};
  svg.text({10.0, 20.0}, "<\"&\x02\xFC", {});
  svg.text({10.0, 20.0}, "up", {.upwards = true});
  svg.disc({1.0, 2.0}, 3.0, {"#000000"});
  svg.line({{1.0, 2.0}, {3.0, 4.0}}, {"#000000"}, 1.0, true);
  const auto root = parse_xml(svg.finish());
  ASSERT_NE(root, nullptr);
  ASSERT_EQ(drawing_in(root)->GetNumberOfNestedElements(), 4);
  EXPECT_STREQ(drawing_in(root)->GetNestedElement(0)->GetCharacterData(), "<\"&?\xEF\xBF\xBD");
}

TEST(TextWidth, CountsCharactersNotBytes) {
  EXPECT_DOUBLE_EQ(text_width("\u00fc", 10.0), text_width("u", 10.0));
  EXPECT_DOUBLE_EQ(text_width("\u5854", 10.0), 10.0) << "as wide as high";
}

TEST(TextWidth, ShortensOnlyWhatDoesNotFit) {
  EXPECT_EQ(shortened("floor 5", 14.0, text_width("floor 5", 14.0)), "floor 5");
  const std::string text = "Geb\u00e4ude \u00fcber der Fuge";
  for (double width = 30.0; width < text_width(text, 14.0); width += 3.0) {
    const std::string part = shortened(text, 14.0, width);
    EXPECT_LE(text_width(part, 14.0), width);
    ASSERT_TRUE(part.ends_with("..."));
    EXPECT_TRUE(text.starts_with(part.substr(0, part.size() - 3)));
    EXPECT_NE(static_cast<unsigned char>(part[part.size() - 4]), 0xC3) << "half of a character";
  }
}

}  // namespace
}  // namespace moat
