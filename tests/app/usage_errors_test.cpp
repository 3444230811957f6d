#include "app/usage_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace moat {
namespace {

class UsageError : public ::testing::Test {
 protected:
  UsageError() {
    parser_.add_option("--gap", gap_);
    parser_.add_option("--out", out_);
    parser_.add_option("--step", step_);
  }

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
  std::string gap_, out_, step_;
};

TEST_F(UsageError, SuggestsTheOptionThatIsMeant) {
  EXPECT_EQ(of({"--gapp=1"}), "moat: error: tower has no option --gapp. Did you mean --gap?\n" + end_);
  EXPECT_EQ(of({"--gab", "1"}), "moat: error: tower has no option --gab. Did you mean --gap?\n" + end_);
  EXPECT_EQ(of({"-gap"}), "moat: error: tower has no option -gap. Did you mean --gap?\n" + end_);
  for (const std::string other : {"--colour", "--bogus", "--storeys"})
    EXPECT_EQ(of({other}), "moat: error: tower has no option " + other + ".\n" + end_);
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
