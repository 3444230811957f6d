#include "motions/readers/record_formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"

namespace moat {
namespace {

using namespace units;

constexpr Acceleration si = m / s / s;

class TwoColumnText : public MotionFiles {
 protected:
  [[nodiscard]] GroundMotion read(std::string_view content, Acceleration unit = si) const {
    return read_two_columns(write("columns.csv", content), unit);
  }
  /// The message without the path that begins it.
  [[nodiscard]] std::string refusal(std::string_view content) const {
    const std::string message = message_of<FileError>([&] { (void)read(content); });
    const std::string beginning = path("columns.csv").string();
    EXPECT_TRUE(message.starts_with(beginning)) << message;
    return message.substr(std::min(message.size(), beginning.size()));
  }
};

TEST_F(TwoColumnText, ReadsEverySeparator) {
  for (const char* content : {"0 1\n0.5 -2\n1 3\n", "0,1\n0.5,-2\n1,3\n", "0;1\n0.5;-2\n1;3\n", "0\t1\n0.5\t-2\n1\t3\n",
                              "  0 , 1 \r\n 0.5 ,\t-2\r\n 1.0E+00 ;  3\r\n", "0    1\n\n0.5  -2\n\n1  3"}) {
    const GroundMotion motion = read(content);
    EXPECT_EQ(motion.time_step(), 0.5) << content;
    EXPECT_EQ((std::vector<double>(motion.samples().begin(), motion.samples().end())),
              (std::vector<double>{1.0, -2.0, 3.0}))
        << content;
  }
}

TEST_F(TwoColumnText, MultipliesByTheUnit) {
  EXPECT_DOUBLE_EQ(read("0 0.5\n1 -1\n", 1 * g).samples()[0], 0.5 * 9.80665);
  EXPECT_DOUBLE_EQ(read("0 0.5\n1 -1\n", cm / s / s).samples()[1], -0.01);
}

TEST_F(TwoColumnText, SkipsCommentsAndOneHeading) {
  const GroundMotion motion =
      read("# synthetic, 1 2\n% more\n\nTime [s], Acceleration [g]\n0, 1  # first\n0.1, 2 % second\n# end\n", 1 * g);
  EXPECT_EQ(motion.samples().size(), 2u);
  EXPECT_EQ(motion.name(), "columns");
  EXPECT_EQ(motion.notes(), (std::vector<std::string>{"columns: Time [s], Acceleration [g]",
                                                      "acceleration column in units of 9.80665 m/s^2"}));
}

TEST_F(TwoColumnText, TakesAFirstTimeOfOneStepAsTheStart) {
  const GroundMotion motion = read("0.01 7\n0.02 8\n0.03 9\n");
  EXPECT_EQ(motion.acceleration_at(0.0), 7.0);
  EXPECT_NEAR(motion.duration(), 0.02, 1e-15);
  EXPECT_EQ(motion.notes().back(), "the file begins at 0.01 s, taken as the start of the motion");
}

TEST_F(TwoColumnText, TakesTheMeanIntervalOfRoundedTimes) {
  // 1/300 s written with 7 decimals: single intervals are off by 3e-5, their mean is not.
  std::string content;
  for (int i = 0; i <= 300; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "%.7f %d\n", i / 300.0, i % 7);
    content += line;
  }
  EXPECT_NEAR(read(content).time_step(), 1.0 / 300.0, 1e-12);
}

TEST_F(TwoColumnText, RefusesUnevenTimes) {
  EXPECT_EQ(refusal("# c\n0 1\n0.01 1\n0.02 1\n\n0.031 1\n"),
            ", line 6: the time interval is 0.011 s here but 0.01 s at the beginning; they may differ by 1 part in "
            "10000. Resample the record to a constant time step, or write its times with more digits.");
  EXPECT_EQ(read("0 1\n0.01 1\n0.0200009 1\n").samples().size(), 3u);
  EXPECT_NE(refusal("0 1\n0.01 1\n0.0200011 1\n").find("line 3: the time interval is 0.0100011 s"), std::string::npos);
  EXPECT_EQ(refusal("0 1\n0.01 1\n0.01 1\n"),
            ", line 3: the time 0.01 s does not follow after 0.01 s. Times must grow from line to line.");
  EXPECT_EQ(refusal("0.1 1\n0 1\n"),
            ", line 2: the time 0 s does not follow after 0.1 s. Times must grow from line to line.");
}

TEST_F(TwoColumnText, RefusesAnotherStart) {
  EXPECT_EQ(refusal("#\n5 1\n5.5 1\n"),
            ", line 2: the first time is 5 s; it must be 0 s or one time step, 0.5 s. Shift the times so that the "
            "motion starts at 0 s.");
  EXPECT_NE(refusal("-0.5 1\n0 1\n").find("the first time is -0.5 s"), std::string::npos);
}

TEST_F(TwoColumnText, RefusesOtherThanTwoColumns) {
  const std::string advice =
      ". Separate the columns with blanks, a tab, a comma or a semicolon, and write decimals with a point.";
  const auto expected = [&](int line, int columns, const std::string& text) {
    return ", line " + std::to_string(line) + ": expected two columns, time in s and acceleration, but found " +
           std::to_string(columns) + " in \"" + text + "\"" + advice;
  };
  EXPECT_EQ(refusal("0 1\n0.1 2 3\n"), expected(2, 3, "0.1 2 3"));
  EXPECT_EQ(refusal("0 1\n0.1\n"), expected(2, 1, "0.1"));
  EXPECT_EQ(refusal("0,00;0,1\n0,01;0,2\n"), expected(1, 4, "0,00;0,1")) << "decimal commas";
  EXPECT_EQ(refusal("0,,1\n0.1,,2\n"), expected(1, 3, "0,,1"));
  EXPECT_EQ(refusal("0,1,\n0.1,2,\n"), expected(1, 3, "0,1,"));
}

TEST_F(TwoColumnText, RefusesWhatIsNotANumber) {
  const std::string advice = ". Each line must hold a time in s and an acceleration; begin remarks with '#'.";
  EXPECT_EQ(refusal("0 1\n0.1 x\n"), ", line 2: \"x\" is not a number" + advice);
  EXPECT_EQ(refusal("t a\ns g\n0 1\n0.1 2\n"), ", line 2: \"s\" is not a number" + advice) << "only one heading";
  EXPECT_EQ(refusal("nan nan\n0.1 2\n0.2 3\n"), ", line 1: \"nan\" is not a number" + advice) << "not a heading";
  EXPECT_EQ(refusal("time 0\n0.1 2\n0.2 3\n"), ", line 1: \"time\" is not a number" + advice) << "not a heading";
  EXPECT_EQ(refusal("0 1\n0.1 inf\n"), ", line 2: \"inf\" is not a number" + advice);
  EXPECT_EQ(refusal("0 1\n, 2\n"), ", line 2: \"\" is not a number" + advice);
}

TEST_F(TwoColumnText, RefusesTooFewLines) {
  EXPECT_EQ(refusal("# nothing\n"), ": expected at least two lines with a time in s and an acceleration, but found 0.");
  EXPECT_EQ(refusal("0 1\n"), ": expected at least two lines with a time in s and an acceleration, but found 1.");
}

TEST_F(TwoColumnText, RefusesAUnitThatIsNotPositive) {
  const auto file = write("columns.csv", "0 1\n1 2\n");
  EXPECT_EQ(message_of<InputError>([&] { (void)read_two_columns(file, 0 * g); }),
            "read_two_columns \"" + file.string() +
                "\": unit = 0 m/s^2 is not allowed; it must be > 0 m/s^2 and finite. Give the unit of the acceleration "
                "column: 1 * g, or 1 * m / s / s.");
}

}  // namespace
}  // namespace moat
