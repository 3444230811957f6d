#include "app/usage_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace moat {
namespace {

class UsageError : public ::testing::Test {
 protected:
  UsageError() { parser_.add_option("--gap", gap_); }

  std::string of(std::vector<std::string> words) {
    try {
      std::ranges::reverse(words);  // CLI11 takes them from the back
      parser_.parse(words);
    } catch (const CLI::ParseError& error) {
      return usage_error(parser_, "tower", error);
    }
    return "";
  }

  const std::string end_ = "moat: --help lists all options.\n";

 private:
  CLI::App parser_;
  std::string gap_;
};

TEST_F(UsageError, SuggestsTheOptionThatIsMeant) {
  EXPECT_EQ(of({"--gapp=1"}), "moat: error: tower has no option --gapp. Did you mean --gap?\n" + end_);
  EXPECT_EQ(of({"--colour"}), "moat: error: tower has no option --colour.\n" + end_);
}

TEST_F(UsageError, TakesTheWordBehindAnUnknownOptionForItsValue) {
  EXPECT_EQ(of({"--colour", "red"}), of({"--colour"}));
  EXPECT_EQ(
      of({"--colour=red", "blue"}),
      "moat: error: tower has no option --colour.\nmoat: error: \"blue\" belongs to no option. A value with a blank "
      "stands in quotes: \"12 cm\".\n" +
          end_);
}

TEST_F(UsageError, PassesOnOtherMistakes) {
  const std::string text = of({"--gap"});
  EXPECT_TRUE(text.starts_with("moat: error: --gap")) << text;
  EXPECT_TRUE(text.ends_with(end_)) << text;
}

}  // namespace
}  // namespace moat
