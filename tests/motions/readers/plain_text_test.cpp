// Columns of plain text.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/readers/read_motion.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;

constexpr Acceleration si = m / s / s;

class PlainText : public testing::WrittenFiles {
 protected:
  [[nodiscard]] std::vector<RecordChannel> channels(std::string_view content, TextColumns columns = {}) const {
    if (!columns.unit) columns.unit = si;
    return read_channels(write("columns.csv", content), columns);
  }
  [[nodiscard]] GroundMotion read(std::string_view content, const TextColumns& columns = {}) const {
    const std::vector<RecordChannel> all = channels(content, columns);
    EXPECT_EQ(all.size(), 1u);
    return motion_of(all[0]);
  }
  /// The message without the path that begins it.
  [[nodiscard]] std::string refusal(std::string_view content, const TextColumns& columns = {}) const {
    const std::string message = testing::message_of<FileError>([&] { (void)channels(content, columns); });
    const std::string beginning = path("columns.csv").string();
    EXPECT_TRUE(message.starts_with(beginning)) << message;
    return message.substr(std::min(message.size(), beginning.size()));
  }
  void expect_refused(std::string_view content, const std::string& words, const TextColumns& columns = {}) const {
    const std::string message = refusal(content, columns);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
};

std::vector<double> values_of(const GroundMotion& motion) { return {motion.samples().begin(), motion.samples().end()}; }

TEST_F(PlainText, ReadsEverySeparator) {
  for (const char* content : {"0 1\n0.5 -2\n1 3\n", "0,1\n0.5,-2\n1,3\n", "0;1\n0.5;-2\n1;3\n", "0\t1\n0.5\t-2\n1\t3\n",
                              "  0 , 1 \r\n 0.5 ,\t-2\r\n 1.0E+00 ;  3\r\n", "0    1\n\n0.5  -2\n\n1  3"}) {
    const GroundMotion motion = read(content);
    EXPECT_EQ(motion.time_step(), 0.5) << content;
    EXPECT_EQ(values_of(motion), (std::vector<double>{1.0, -2.0, 3.0})) << content;
  }
}

TEST_F(PlainText, MultipliesByTheUnit) {
  EXPECT_DOUBLE_EQ(read("0 0.5\n1 -1\n", {.unit = 1 * g}).samples()[0], 0.5 * 9.80665);
  EXPECT_DOUBLE_EQ(read("0 0.5\n1 -1\n", {.unit = cm / s / s}).samples()[1], -0.01);
}

TEST_F(PlainText, SkipsCommentsAndOneHeading) {
  const GroundMotion motion = read(
      "# synthetic, 1 2\n% more\n! and more\n// most\n\nTime [s], Acceleration [g]\n0, 1  # first\n0.1, -1 % second\n# "
      "end\n",
      {.unit = 1 * g});
  EXPECT_EQ(motion.samples().size(), 2u);
  EXPECT_EQ(motion.name(), "columns");
  EXPECT_EQ(motion.notes(), (std::vector<std::string>{"columns: Time [s], Acceleration [g]",
                                                      "accelerations in units of 9.80665 m/s^2"}));
}

TEST_F(PlainText, TakesAFirstTimeOfOneStepAsTheStart) {
  const GroundMotion motion = read("0.01 7\n0.02 -8\n0.03 1\n");
  EXPECT_EQ(motion.acceleration_at(0.0), 7.0);
  EXPECT_NEAR(motion.duration(), 0.02, 1e-15);
  EXPECT_EQ(motion.notes().back(), "the file begins at 0.01 s, taken as the start of the motion");
  EXPECT_EQ(refusal("#\n5 1\n5.5 1\n"),
            ", line 2: the first time is 5 s; it must be 0 s or one time step, 0.5 s. Shift the times so that the "
            "motion starts at 0 s.");
  expect_refused("-0.5 1\n0 1\n", "the first time is -0.5 s");
}

// 1/256 s with four digits is 0.0039, 0.0078, 0.0117: intervals differ by 2 %, and the times are even.
TEST_F(PlainText, RoundedTimesAreEven) {
  for (const double rate : {256.0, 300.0, 128.0, 75.0})
    for (const int digits : {4, 5, 7}) {
      std::string content;
      for (int i = 0; i < 2000; ++i) {
        char line[64];
        std::snprintf(line, sizeof line, "%.*f %d\n", digits, i / rate, i % 2 == 0 ? 1 : -1);
        content += line;
      }
      EXPECT_NEAR(read(content).time_step() * rate, 1.0, 2e-5) << rate << " " << digits;
    }
  // Single precision prints 0.01 as 0.0099999998.
  std::string content;
  for (int i = 0; i < 2000; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "%.10f %d\n", static_cast<double>(static_cast<float>(i) * 0.01F), i % 2);
    content += line;
  }
  EXPECT_NEAR(read(content).time_step(), 0.01, 1e-8);
}

TEST_F(PlainText, RefusesUnevenTimes) {
  EXPECT_EQ(refusal("# c\n0 1\n0.0100 1\n0.0200 1\n\n0.0310 1\n"),
            ", line 6: times are not even: 0.031 s is 0.001 s behind 3 steps of 0.01 s. Resample the record to a "
            "constant step.");
  expect_refused("0 1\n0.01 1\n0.01 1\n",
                 "line 3: the time 0.01 s stands twice: the times have too few digits. Give the step: --record-step");
  // A lost row in a long record.
  std::string content;
  for (int i = 0; i < 1000; ++i)
    if (i != 500) content += std::to_string(0.005 * i) + " 1\n";
  expect_refused(content, "line 501: times are not even: 2.505 s is 0.005 s behind 500 steps of 0.005 s");
}

TEST_F(PlainText, ReadsSeriesWithAStep) {
  const TextColumns step{.step = 0.02 * s};
  EXPECT_EQ(values_of(read("1\n-2\n3\n", step)), (std::vector<double>{1, -2, 3}));
  const GroundMotion motion = read("1 -2 3 -4 5 -6 7 -8\n9 1 -1 0 0 0 0 0\n1 -1\n", step);
  EXPECT_EQ(motion.samples().size(), 18u) << "the last row is shorter";
  EXPECT_EQ(motion.samples()[8], 9.0);
  EXPECT_EQ(motion.time_step(), 0.02);
  EXPECT_EQ(read("1 -2 3\n-1 0 1\n", {.step = 0.02 * s, .columns = "series"}).samples().size(), 6u);
  expect_refused("1\n-2\n3\n", "it does not say its time step. Give it: --record-step");
  expect_refused("1 -2 3 -4 5\n0 1 2\n0 1 2 3 4\n", "line 3: expected 5 columns, as above, but found 5", step);
  expect_refused("1 2 3 4 5 6 7 8 9 10 11 12 13\n1 2 3 4 5 6 7 8 9 10 11 12 13\n", "found 13 columns; 1 to 12 are read",
                 step);
}

TEST_F(PlainText, ReadsTheStepInItsWords) {
  for (const char* words : {"# dt = 0.02", "% DT=0.02 s", "# time step: 0.02 s", "# time step (s) = .02",
                            "# time step (ms) = 20", "# DT = 20 milliseconds", "! 50 Hz", "# sampling rate: 50 Hz",
                            "NPTS= 3, DT= .02 SEC", "# Delta t 20 ms", "3 0.02", "// Time interval 2.0E-02"})
    EXPECT_NEAR(read(std::string{words} + "\n1\n-2\n1\n").time_step(), 0.02, 1e-15) << words;
  for (const char* words : {"# width = 0.02", "# low-pass filter at 25 Hz", "# dtt 3"})
    expect_refused(std::string{words} + "\n1\n-2\n1\n", "it does not say its time step");
  expect_refused("4 0.02\n1\n-2\n1\n", "the first line announces 4 values, but the file holds 3");
  const GroundMotion other = read("# dt = 0.02\n1\n-2\n1\n", {.step = 0.01 * s});
  EXPECT_EQ(other.time_step(), 0.01);
  EXPECT_EQ(other.notes().back(), "the file says a step of 0.02 s; 0.01 s were given");
}

TEST_F(PlainText, ColumnsThatAreNoTimesMustBeNamed) {
  const std::string pair = "0.0 0.5\n0.25 0.0\n-0.125 1.0\n";
  expect_refused(pair,
                 "the file has 2 columns, of which the first does not grow, so it is no time. Name them: "
                 "--record-columns x,y");
  for (const char* several : {"0 1 2\n0.1 2 3\n", "0 1 2 3\n0.1 2 3 4\n", "1 0 2\n0 1 2\n"})
    expect_refused(several, "Name them");
  const std::vector<RecordChannel> two = channels(pair, {.step = 0.02 * s, .columns = "x,y"});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[1].samples, (std::vector<double>{0.5, 0.0, 1.0}));
  const std::vector<RecordChannel> three = channels("0 1 2 3\n0.1 2 3 4\n", {.columns = "time,z,x,-"});
  ASSERT_EQ(three.size(), 2u);
  EXPECT_TRUE(three[0].vertical);
  EXPECT_EQ(three[1].samples, (std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(three[1].step, 0.1);
  expect_refused(pair, "it has 2 columns, but --record-columns names 3: time,x,y.", {.columns = "time,x,y"});
  for (const char* columns : {"x,x", "x,time", "a,b", "t,x"})
    EXPECT_NE(testing::message_of<InputError>([&] {
                (void)channels(pair, {.columns = columns});
              }).find("is not allowed; it must be \"series\", or x, y, z and -"),
              std::string::npos)
        << columns;
  expect_refused(pair, "no column is named x, y or z", {.step = 1 * s, .columns = "-,-"});
}

TEST_F(PlainText, RefusesRowsOfOtherLengths) {
  const std::string advice =
      ". Separate the columns with blanks, a tab, a comma or a semicolon, and write decimals with a point.";
  EXPECT_EQ(refusal("0 1\n0.1 2 3\n0.2 1\n"),
            ", line 2: expected 2 columns, as above, but found 3 in \"0.1 2 3\"" + advice);
  EXPECT_EQ(refusal("1e30 0.005\n0.1\n0.2\n"),
            ", line 2: expected 2 columns, as above, but found 1 in \"0.1\"" + advice)
      << "no number of values";
  EXPECT_EQ(refusal("0 1\n0.1\n0.2 1\n"), ", line 2: expected 2 columns, as above, but found 1 in \"0.1\"" + advice);
  expect_refused("0,00;0,1\n0,01;0,2\n", "the file has 4 columns");
  expect_refused("0,,1\n0.1,,2\n", "\"\" is not a number");
}

TEST_F(PlainText, RefusesWhatIsNotANumber) {
  const std::string advice = ". Each line must hold numbers; begin remarks with '#'.";
  EXPECT_EQ(refusal("0 1\n0.1 x\n"), ", line 2: \"x\" is not a number" + advice);
  EXPECT_EQ(refusal("t a\n0 1\ns g\n0.1 2\n"), ", line 3: \"s\" is not a number" + advice) << "only one heading";
  EXPECT_EQ(refusal("0.1 nan\n0.2 3\n"), ", line 1: \"nan\" is not a number" + advice) << "not a heading";
  EXPECT_EQ(refusal("0 1\n0.1 inf\n"), ", line 2: \"inf\" is not a number" + advice);
  expect_refused("nan nan\n0.1 2\n0.2 3\n", "\"nan\" is not a number");
  expect_refused("t a\ns g\n0 1\n0.1 2\n", "unknown format");
}

TEST_F(PlainText, RefusesTooFewLines) {
  EXPECT_EQ(refusal("0 1\n"), ": expected at least two lines of numbers, but found 1.");
  expect_refused("# nothing\n", "unknown format");
  expect_refused("case,record,drift\n0,A090,0.1\n1,A180,0.2\n", "unknown format");
}

TEST_F(PlainText, RefusesUnitsAndStepsThatAreNotPositive) {
  EXPECT_NE(
      testing::message_of<InputError>([&] {
        (void)channels("0 1\n1 2\n", {.unit = 0 * g});
      }).find("unit = 0 m/s^2 is not allowed; it must be > 0 m/s^2 and finite. Give the unit of the accelerations"),
      std::string::npos);
  EXPECT_NE(testing::message_of<InputError>([&] {
              (void)channels("1\n2\n", {.step = 0 * s});
            }).find("step = 0 s is not allowed"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
