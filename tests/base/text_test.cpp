// Texts of every kind: names, numbers, lines for a terminal.

#include "base/text/nearest_name.hpp"
#include "base/text/number_format.hpp"
#include "base/text/terminal.hpp"
#include "base/text/type_name.hpp"
#include "base/text/utf8_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <locale>
#include <new>
#include <sstream>
#include <utility>

namespace moat {

struct Outer {
  struct Inner {};
};
template <class T>
struct Wrapped {};

namespace {

TEST(NearestName, IsFoundForTypingMistakes) {
  const std::vector<std::string> options{"gap", "out", "step", "record", "record-unit", "project", "frame-interval"};
  for (const auto& [misspelt, meant] :
       std::vector<std::pair<std::string, std::string>>{{"gab", "gap"},
                                                        {"gapp", "gap"},
                                                        {"otu", "out"},
                                                        {"recrod", "record"},
                                                        {"recordunit", "record-unit"},
                                                        {"projekt", "project"},
                                                        {"frame_intervall", "frame-interval"}})
    EXPECT_EQ(nearest_name(options, misspelt), meant) << misspelt;
}

TEST(NearestName, StandsInAQuestion) {
  EXPECT_EQ(did_you_mean({"gap", "out"}, "gab", "--"), " Did you mean --gap?");
  EXPECT_EQ(did_you_mean({"run", "new"}, "rum"), " Did you mean run?");
  EXPECT_EQ(did_you_mean({"run", "new"}, "bogus"), "");
}

TEST(NearestName, IsNoOtherWord) {
  const std::vector<std::string> options{"out", "step", "end", "gap", "force", "hardening_stiffness"};
  for (const std::string other : {"bogus", "storeys", "seed", "case", "colour", "in", "", "x", "damping_stiffness"})
    EXPECT_EQ(nearest_name(options, other), "") << other;
}

TEST(NumberFormat, FixedHasSoManyDecimals) {
  EXPECT_EQ(to_fixed(0.125, 2), "0.12");
  EXPECT_EQ(to_fixed(-43.875, 1), "-43.9");
  EXPECT_EQ(to_fixed(1e15, 0), "1000000000000000");
  EXPECT_EQ(to_fixed(NAN, 2), "nan");
}

TEST(NumberFormat, SignificantIsThatOfPrintf) {
  EXPECT_EQ(to_significant(0.0125, 6), "0.0125");
  EXPECT_EQ(to_significant(1.0, 6), "1");
  EXPECT_EQ(to_significant(1.234e-9, 2), "1.2e-09");
  EXPECT_EQ(to_significant(123456789.0, 6), "1.23457e+08");
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Numbers, KeepAllTheirDigits) {
  for (const double value : {0.01, 1.0 / 60.0, 9.80665, 1.0 / 3.0, -1e-300, 0.1 + 0.2})
    EXPECT_EQ(std::stod(to_exact(value)), value);
  EXPECT_EQ(to_exact(0.005), "0.005");
  EXPECT_EQ(to_exact(90.0), "90");
}

TEST(NumberFormat, DoesNotFollowTheLocaleOfTheProgram) {
  const std::locale before = std::locale::global(std::locale{std::locale::classic(), new Comma});
  EXPECT_EQ(to_fixed(0.5, 1), "0.5");
  EXPECT_EQ(to_significant(0.5, 3), "0.5");
  std::locale::global(before);
}

bool is_control(unsigned char byte) { return (byte < 0x20 && byte != '\n') || byte == 0x7F; }

TEST(Printable, HasNoControlCharacters) {
  for (int code = 0; code < 256; ++code)
    for (const std::string before : {"a", "\x1b", "\xC2", "\xE2\x80", "\xC3\xA9", "\n", ""}) {
      const std::string shown = printable(before + static_cast<char>(code) + "[31m");
      for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_FALSE(is_control(static_cast<unsigned char>(shown[i]))) << code << " behind " << before;
        // U+0080 to U+009F.
        EXPECT_FALSE(shown[i] == '\xC2' && i + 1 < shown.size() && static_cast<unsigned char>(shown[i + 1]) >= 0x80 &&
                     static_cast<unsigned char>(shown[i + 1]) < 0xA0)
            << code << " behind " << before;
      }
      EXPECT_EQ(printable(shown), shown) << "nothing is left";
    }
}

TEST(Printable, NamesThemByTheirCode) {
  EXPECT_EQ(printable("esc\x1b[31m.AT2"), "esc\\u001b[31m.AT2");
  EXPECT_EQ(printable(std::string_view{"\0\a\b\t\r\x7F", 6}), "\\u0000\\u0007\\u0008\\u0009\\u000d\\u007f");
  EXPECT_EQ(printable("a\xC2\x9B"
                      "31m"),
            "a\\u009b31m");
  EXPECT_EQ(printable("a\x9B"
                      "31m"),
            "a\\u009b31m")
      << "terminals without UTF-8 obey this byte";
}

TEST(Printable, LeavesNewlinesAndOtherText) {
  for (const char* text :
       {"", "two\nlines\n", "Türme, 5 \xC2\xB5m, \xC2\xA0, \xE2\x86\x92 \xE2\x80\x9C\xE2\x82\x9D \xF0\x9F\x8F\x9B",
        "\\u001b is not escaped again"})
    EXPECT_EQ(printable(text), text);
}

TEST(PrintText, PrintsPrintableText) {
  std::ostringstream stream;
  print_text(print_text(stream, "a\x1b"), "b\n");
  EXPECT_EQ(stream.str(), "a\\u001bb\n");
}

TEST(ReasonOf, IsTheMessageOrTheLackOfMemory) {
  EXPECT_STREQ(reason_of(std::runtime_error{"a reason"}), "a reason");
  EXPECT_TRUE(std::string{reason_of(std::bad_alloc{})}.starts_with("There is not enough memory."));
}

struct Hidden {};

TEST(TypeName, IsThatOfTheSourceWithoutNamespaces) {
  struct Local {};
  EXPECT_EQ(type_name<Outer>(), "Outer");
  EXPECT_EQ(type_name<Outer::Inner>(), "Inner");
  EXPECT_EQ(type_name<Hidden>(), "Hidden");
  EXPECT_EQ(type_name<Local>(), "Local");
  // The arguments stand as the compiler writes them.
  EXPECT_TRUE(type_name<Wrapped<Outer>>().starts_with("Wrapped<")) << type_name<Wrapped<Outer>>();
  EXPECT_EQ(type_name<double>(), "double");
}

TEST(Utf8Text, KnowsLatin1FromUtf8) {
  EXPECT_TRUE(is_utf8("T\xC3\xBCr"));
  EXPECT_TRUE(is_utf8(""));
  EXPECT_FALSE(is_utf8("T\xFCr"));
}

TEST(Utf8Text, ReplacesOtherBytes) {
  EXPECT_EQ(as_utf8("T\xC3\xBCr"), "T\xC3\xBCr");
  EXPECT_EQ(as_utf8("T\xFCr"), "T\xEF\xBF\xBDr");
}

}  // namespace
}  // namespace moat
