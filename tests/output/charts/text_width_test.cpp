#include "output/charts/text_width.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(TextWidth, AddsTheAdvancesOfArial) {
  // Arial: digits 556, space 278, "W" 944, "i" 222 thousandths; 1.15 for wider faces.
  EXPECT_DOUBLE_EQ(text_width("12", 10.0), 1.15 * 11.12);
  EXPECT_DOUBLE_EQ(text_width("W i", 20.0), 1.15 * 20.0 * 1.444);
  EXPECT_DOUBLE_EQ(text_width("", 20.0), 0.0);
}

TEST(TextWidth, CountsCharactersNotBytes) {
  EXPECT_DOUBLE_EQ(text_width("ü", 10.0), 1.15 * 6.0);
  EXPECT_DOUBLE_EQ(text_width("塔", 10.0), 1.15 * 10.0);
}

TEST(TextWidth, ShortensOnlyWhatDoesNotFit) {
  EXPECT_EQ(shortened("floor 5", 14.0, text_width("floor 5", 14.0)), "floor 5");
  const std::string text = "Gebäude über der Fuge";
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
