#include "motions/readers/number_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace moat {
namespace {

TEST(NumberText, ReadsWhatFortranAndCWrite) {
  EXPECT_EQ(parse_number("-.1234E-03").value, -0.1234e-3);
  EXPECT_EQ(parse_number("0.1D-02").value, 0.1e-2);
  EXPECT_EQ(parse_number("1.5d+1").value, 15.0);
  EXPECT_EQ(parse_number("+5.").value, 5.0);
  EXPECT_EQ(parse_number("12").value, 12.0);
  EXPECT_EQ(parse_number("1e10").value, 1e10);
  EXPECT_EQ(parse_number("6.5114120E-005").value, 6.511412e-5);
  for (const char* text : {"-.1234E-03", "0.1D-02", "+5.", "12"})
    EXPECT_EQ(parse_number(text).problem, nullptr) << text;
}

TEST(NumberText, RefusesEverythingElse) {
  for (const char* text :
       {"", "-", ".", "+.", "nan", "inf", "-Infinity", "****", "abc", "0x10", "1,5", "1.2.3", "--1", "1 2", " 1", "1 "})
    EXPECT_STREQ(parse_number(text).problem, "is not a number") << '"' << text << '"';
  EXPECT_STREQ(parse_number("1.0E").problem, "has no digits in its exponent");
  EXPECT_STREQ(parse_number("1.0E+").problem, "has no digits in its exponent");
  EXPECT_STREQ(parse_number("1.0E-0312").problem, "has more than three digits in its exponent");
  EXPECT_STREQ(parse_number("1E400").problem, "is too large or too small for a double");
  EXPECT_STREQ(parse_number("1E-400").problem, "is too large or too small for a double");
}

TEST(NumberText, StopsBehindTheFirstNumber) {
  const ScannedNumber with_exponent = scan_number("-.123E-03-.456E-03");
  EXPECT_EQ(with_exponent.value, -0.123e-3);
  EXPECT_EQ(with_exponent.length, std::string{"-.123E-03"}.size());
  EXPECT_TRUE(with_exponent.has_exponent);
  const ScannedNumber without_exponent = scan_number("0.5-3");
  EXPECT_EQ(without_exponent.length, 3u);
  EXPECT_FALSE(without_exponent.has_exponent);
}

}  // namespace
}  // namespace moat
