#include "app/progress_bar.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace moat {
namespace {

// The tests' standard error is captured in a file, which is no terminal.
std::string log_of(const std::function<void()>& action) {
  testing::internal::CaptureStderr();
  action();
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressBar, WritesALineForEveryTenPercentToALog) {
  EXPECT_EQ(log_of([] {
              ProgressBar bar{"gaps", "cases", 0.0};
              for (int done = 1; done <= 100; ++done) bar(done, 100);
            }),
            "moat: gaps:  10 % of 100 cases\nmoat: gaps:  20 % of 100 cases\nmoat: gaps:  30 % of 100 cases\n"
            "moat: gaps:  40 % of 100 cases\nmoat: gaps:  50 % of 100 cases\nmoat: gaps:  60 % of 100 cases\n"
            "moat: gaps:  70 % of 100 cases\nmoat: gaps:  80 % of 100 cases\nmoat: gaps:  90 % of 100 cases\n"
            "moat: gaps: 100 % of 100 cases\n");
}

TEST(ProgressBar, WritesOneLineWhereSeveralTenthsPassAtOnce) {
  EXPECT_EQ(log_of([] {
              ProgressBar bar{"", "s", 0.0};
              bar(0.5, 4.0);
              bar(1.9, 4.0);
              bar(4.0, 4.0);
            }),
            "moat:  10 % of 4 s\nmoat:  40 % of 4 s\nmoat: 100 % of 4 s\n");
}

TEST(ProgressBar, ASumOfStepsThatIsShortByRoundOffIsComplete) {
  const std::string log = log_of([] {
    ProgressBar bar{"", "s", 0.0};
    double time = 0.0;
    for (int step = 0; step < 10; ++step) bar(time += 0.1, 1.0);
    ASSERT_LT(time, 1.0);
  });
  EXPECT_NE(log.find("100 % of 1 s"), std::string::npos) << log;
}

TEST(ProgressBar, WritesNothingToALogInItsQuietTime) {
  EXPECT_EQ(log_of([] {
              ProgressBar bar{"gaps", "cases", std::numeric_limits<double>::infinity()};
              for (int done = 1; done <= 100; ++done) bar(done, 100);
              bar.clear();
            }),
            "");
}

}  // namespace
}  // namespace moat
