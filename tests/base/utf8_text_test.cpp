#include "base/text/utf8_text.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

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
