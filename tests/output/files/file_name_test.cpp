#include "output/files/file_name.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(FileName, HasSmallLettersDigitsAndUnderscores) {
  EXPECT_EQ(file_name_of("Impacts over gap"), "impacts_over_gap");
  EXPECT_EQ(file_name_of("2.659 s, moat left (A)"), "2_659_s_moat_left_a");
  EXPECT_EQ(file_name_of("../etc/passwd"), "etc_passwd");
  EXPECT_EQ(file_name_of("H\u00f6he"), "h_he");
}

TEST(FileName, IsNeverEmpty) {
  for (const char* title : {"", "  ", "\u00e4\u00f6"}) EXPECT_EQ(file_name_of(title), "chart") << title;
}

}  // namespace
}  // namespace moat
