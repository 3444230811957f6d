#include "launcher/text.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "launcher/process.hpp"

namespace moat::launcher {
namespace {

TEST(ShellQuoted, IsReadBackByAShell) {
  for (const char* word : {"plain", "two words", "it's", "$(touch x)", "`a`", "\\", "\"", "*", "#1", "", "~", "a;b&c"})
    EXPECT_EQ(output_of({"sh", "-c", std::string{"printf %s "} + shell_quoted(word)}).text, word);
  EXPECT_EQ(shell_quoted("plain/name.cpp"), "plain/name.cpp");
}

TEST(RegexQuoted, MatchesTheTextAndNothingElse) {
  for (const char* text : {"/home/a b/moat", "c++.d", "[x]{2}(y)|z", "^a$", "\\d*?"})
    EXPECT_TRUE(std::regex_match(text, std::regex{regex_quoted(text)})) << text;
  EXPECT_FALSE(std::regex_match("c++xd", std::regex{regex_quoted("c++.d")}));
}

TEST(Replaced, DoesNotReadItsOwnWords) { EXPECT_EQ(replaced("a$b$", "$", "$$"), "a$$b$$"); }

}  // namespace
}  // namespace moat::launcher
