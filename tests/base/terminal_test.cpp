#include "base/text/terminal.hpp"

#include <gtest/gtest.h>

#include <new>
#include <sstream>

namespace moat {
namespace {

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

}  // namespace
}  // namespace moat
