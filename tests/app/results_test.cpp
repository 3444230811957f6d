// What a run says on the terminal.

#include "app/results.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(TerminalSummary, AlignsPeriodsOfAnyName) {
  CaseResult result;
  result.periods = {{"fixed base", 0.5}, {"a building of a long name: first mode, post-yield bearings", 2.5}};
  const std::string text = terminal_summary(result);
  EXPECT_NE(text.find("  fixed base                                                  0.500\n"
                      "  a building of a long name: first mode, post-yield bearings  2.500\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace moat
