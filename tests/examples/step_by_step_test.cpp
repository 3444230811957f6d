// The tour that drives an analysis by hand.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "run_program.hpp"

namespace moat {
namespace {

class StepByStep : public testing::InTemporaryFolder {};

TEST_F(StepByStep, PrintsEveryTouchAndOpeningInTurn) {
  const auto result = testing::run_program(FOURTH_TOUR, {}, folder);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::istringstream lines{result.output};
  int events = 0;
  bool touching = false;
  double last = 0.0;
  for (std::string line; std::getline(lines, line);) {
    const bool touch = line.find(" touches at ") != std::string::npos, opening = line.ends_with(" opens");
    if (!touch && !opening) continue;
    ++events;
    EXPECT_EQ(touch, !touching) << line;
    touching = touch;
    const double time = std::stod(line);
    EXPECT_GT(time, last) << line;
    last = time;
  }
  EXPECT_GT(events, 0) << result.output;
  EXPECT_FALSE(touching) << "it comes to rest away from the wall";
  EXPECT_NE(result.output.find(" " + std::to_string(events) + " events"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace moat
