#include "launcher/text.hpp"

#include <gtest/gtest.h>

#include "launcher/process.hpp"

namespace moat::launcher {
namespace {

TEST(ShellQuoted, IsReadBackByAShell) {
  for (const char* word : {"plain", "two words", "it's", "$(touch x)", "`a`", "\\", "\"", "*", "#1", "", "~", "a;b&c"})
    EXPECT_EQ(output_of({"sh", "-c", std::string{"printf %s "} + shell_quoted(word)}).text, word);
  EXPECT_EQ(shell_quoted("plain/name.cpp"), "plain/name.cpp");
}

TEST(Replaced, DoesNotReadItsOwnWords) { EXPECT_EQ(replaced("a$b$", "$", "$$"), "a$$b$$"); }

}  // namespace
}  // namespace moat::launcher
