// The functions through which texts of users go.

#include <gtest/gtest.h>

#include <string>

#include "base/sha256.hpp"
#include "base/text/terminal.hpp"
#include "base/text/utf8_text.hpp"

namespace moat {
namespace {

TEST(PlainText, DoesNotTurnItsDirection) {
  EXPECT_EQ(printable("a\xE2\x80\xAE"
                      "b\xE2\x81\xA6"),
            "a\\u202eb\\u2066");
  EXPECT_EQ(printable("\xE2\x80\xA9\xE2\x81\xAA"), "\xE2\x80\xA9\xE2\x81\xAA") << "neighbours of these characters";
  EXPECT_EQ(as_plain_text("a\xE2\x80\xAE"
                          "b\xE2\x81\xA6\xEF\xBF\xBE"),
            "a?b??");
  const std::string hebrew = "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D";
  EXPECT_EQ(printable(hebrew), hebrew);
  EXPECT_EQ(as_plain_text(hebrew), hebrew);
}

// RFC 4648 and FIPS 180-4: of nothing, and of "abc".
TEST(PlainText, IsKnownByItsHash) {
  EXPECT_EQ(sha256_in_base64(""), "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  EXPECT_EQ(sha256_in_base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

}  // namespace
}  // namespace moat
