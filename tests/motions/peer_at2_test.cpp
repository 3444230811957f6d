#include "motions/readers/read_motion.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"

namespace moat {
namespace {

class PeerAt2 : public MotionFiles {
 protected:
  /// A synthetic file with the usual first three lines.
  [[nodiscard]] std::filesystem::path file(const std::string& fourth_line, const std::string& values) const {
    return write("synthetic.AT2",
                 "SYNTHETIC TEST RECORD\nNowhere, 1/1/2000, Test, 0\nACCELERATION TIME SERIES IN UNITS OF G\n" +
                     fourth_line + "\n" + values);
  }

  /// The values of a file, back in g.
  [[nodiscard]] static std::vector<double> values_in_g(const std::filesystem::path& path) {
    const GroundMotion motion = read_motion(path);
    std::vector<double> values(motion.samples().begin(), motion.samples().end());
    for (double& value : values) value /= standard_gravity;
    return values;
  }

  [[nodiscard]] static std::string refusal(const std::filesystem::path& path) {
    return message_of<FileError>([&] { (void)read_motion(path); });
  }
};

void expect_values(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_DOUBLE_EQ(found[i], expected[i]) << i;
}

TEST_F(PeerAt2, ReadsCountAndTimeStepInAnyLayout) {
  for (const char* line :
       {"NPTS=      3, DT=   .0050 SEC", "NPTS=      3  DT=   .0050 SEC,                ", "npts = 3, dt = 0.005",
        "NPTS=3,DT=.0050SEC", "NPTS=   3, DT=   .0050 SEC,   4 POLE @    30.00000 HZ,  -5 POLE @      .05000",
        "3    0.0050    NPTS, DT", "   3  .5E-02  NPTS, DT  (SEC)"}) {
    const GroundMotion motion = read_motion(file(line, "  .1  -.2\n  .3\n"));
    EXPECT_EQ(motion.time_step(), 0.005) << line;
    ASSERT_EQ(motion.samples().size(), 3u) << line;
    EXPECT_DOUBLE_EQ(motion.samples()[1], -0.2 * 9.80665) << line;
  }
}

TEST_F(PeerAt2, KeepsNameAndHeader) {
  const GroundMotion motion = read_motion(file("NPTS= 2, DT= .01 SEC   ", "-1 1\n"));
  EXPECT_EQ(motion.name(), "synthetic");
  EXPECT_EQ(motion.notes(),
            (std::vector<std::string>{"SYNTHETIC TEST RECORD", "Nowhere, 1/1/2000, Test, 0",
                                      "ACCELERATION TIME SERIES IN UNITS OF G", "NPTS= 2, DT= .01 SEC"}));
}

TEST_F(PeerAt2, AcceptsOlderWordsOfTheUnitsLine) {
  for (const char* line : {"ACCELERATION TIME HISTORY IN UNITS OF G", "Acceleration time history in units of g  ",
                           "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=30.0 Hz"}) {
    const auto path = write("synthetic.AT2", "A\nB\n" + std::string{line} + "\n2 0.01 NPTS, DT\n0 1\n");
    EXPECT_EQ(read_motion(path).samples().size(), 2u) << line;
  }
}

TEST_F(PeerAt2, AcceptsWindowsLineEndingsTrailingBlankLinesAndAByteOrderMark) {
  const auto path = write("synthetic.AT2",
                          "\xEF\xBB\xBFSYNTHETIC\r\nB\r\nACCELERATION TIME SERIES IN UNITS OF G\r\n"
                          "NPTS= 4, DT= .01 SEC,     \r\n  .1E+00  .2E+00\r\n  .3E+00   .4E+00   \r\n  \r\n\r\n\r\n");
  expect_values(values_in_g(path), {0.1, 0.2, 0.3, 0.4});
  EXPECT_EQ(read_motion(path).notes()[0], "SYNTHETIC");
}

TEST_F(PeerAt2, NeedsNoLineEndAtTheEnd) {
  expect_values(values_in_g(file("2 0.01 NPTS, DT", "0.5 0.25")), {0.5, 0.25});
}

TEST_F(PeerAt2, ReadsExponentsMarkedByEOrD) {
  expect_values(values_in_g(file("NPTS= 4, DT= .01 SEC", "-.1234E-03 0.1D-02\n+.5d+00 .7e0\n")),
                {-0.1234e-3, 0.1e-2, 0.5, 0.7});
}

TEST_F(PeerAt2, SeparatesTouchingValuesAtASignAfterAnExponent) {
  expect_values(values_in_g(file("NPTS= 5, DT= .01 SEC", "-.1234567E-03-.7654321E-01 .5E+00-.1E+00+.2E+00\n")),
                {-0.1234567e-3, -0.7654321e-1, 0.5, -0.1, 0.2});
}

TEST_F(PeerAt2, RefusesTouchingValuesThatCouldBeReadInTwoWays) {
  // "1.5-3" is 1.5e-3 for Fortran but two values for a human; "E-030.456" may be E-03 and 0.456.
  for (const char* values :
       {"1.5-3", "0.123-0.456", "-.123E-03.456E-03", "-.123E-030.456E-03", "0.1230.456", ".1,.2"}) {
    const auto path = file("NPTS= 2, DT= .01 SEC", "0.0\n" + std::string{values} + " 0.5\n");
    EXPECT_EQ(refusal(path), path.string() + ", line 6: \"" + values +
                                 "\" is not one number, and where one ends and the next begins is not certain. "
                                 "Separate the values with blanks.");
  }
}

TEST_F(PeerAt2, RefusesWhatIsNotANumber) {
  for (const char* word : {"*******", "NaN", "inf", "END"}) {
    const auto path = file("NPTS= 3, DT= .01 SEC", "0.0 0.1\n  " + std::string{word} + "\n");
    EXPECT_EQ(refusal(path), path.string() + ", line 6: \"" + word +
                                 "\" is not a number. Only accelerations in g may follow the header.");
  }
}

TEST_F(PeerAt2, RefusesACountThatDiffersFromTheHeader) {
  const auto few = file("NPTS= 5, DT= .01 SEC", "1 2 3 4\n");
  EXPECT_EQ(refusal(few), few.string() +
                              ": the header announces NPTS = 5 values, but the file holds 4. "
                              "The file is damaged or was cut; fetch it again.");
  const auto many = file("3 .01 NPTS, DT", "1 2 3 4\n");
  EXPECT_EQ(refusal(many), many.string() +
                               ": the header announces NPTS = 3 values, but the file holds 4. "
                               "The file is damaged or was cut; fetch it again.");
  const auto absurd = file("NPTS= 999999999999999999, DT= .01 SEC", "1 2\n");
  EXPECT_NE(refusal(absurd).find("NPTS = 999999999999999999 values, but the file holds 2"), std::string::npos);
}

TEST_F(PeerAt2, RefusesOtherUnits) {
  for (const char* line : {"SPEED TIME SERIES IN UNITS OF CM/S", "ACCELERATION TIME SERIES IN UNITS OF GAL",
                           "ACCELERATION TIME SERIES IN UNITS OF G/10", "ACCELERATION TIME SERIES IN UNITS OF"}) {
    const auto path = write("synthetic.AT2", "A\nB\n" + std::string{line} + "\n2 0.01 NPTS, DT\n0 1\n");
    EXPECT_EQ(refusal(path), path.string() +
                                 ", line 3: this line of a PEER AT2 file must say \"ACCELERATION TIME SERIES IN UNITS "
                                 "OF G\", but it says \"" +
                                 line +
                                 "\". Only accelerations in g are read; convert the file, or save it as two columns.");
  }
}

TEST_F(PeerAt2, RefusesAFourthLineItDoesNotUnderstand) {
  for (const char* line :
       {"NPTS= 2", "NPTS= 2, DT= fast", "NPTS= 2., DT= .01 SEC", "NPTS= -2, DT= .01 SEC", "NPTS= 2, DT= 5 MSEC",
        "0.01 2 NPTS, DT", "2 0.01", "2 0.01 DT, NPTS", "2 5 MSEC NPTS, DT"}) {
    const auto path = file(line, "0 1\n");
    EXPECT_EQ(refusal(path), path.string() +
                                 ", line 4: expected the number of values and the time step in s, as \"NPTS= 5600, DT= "
                                 ".0050 SEC\" or \"5600 0.0050 NPTS, DT\", but found \"" +
                                 line + "\".");
  }
  const auto single = file("NPTS= 1, DT= .01 SEC", "0\n");
  EXPECT_EQ(refusal(single), single.string() + ", line 4: NPTS = 1 is not allowed; it must be >= 2.");
  const auto frozen = file("NPTS= 2, DT= 0.0 SEC", "0 1\n");
  EXPECT_EQ(refusal(frozen), frozen.string() + ", line 4: DT = 0 s is not allowed; it must be > 0 s.");
}

TEST_F(PeerAt2, RefusesFilesThatAreNotThereOrTooShort) {
  EXPECT_EQ(refusal(path("none.AT2")), path("none.AT2").string() + ": there is no such file. Check the path.");
  EXPECT_EQ(refusal(path("")), path("").string() + ": this is a folder. Give one file in it.");
  const auto brief = write("short.AT2", "A\nB\n");
  EXPECT_EQ(refusal(brief), brief.string() + ": a PEER AT2 file begins with 4 header lines, but this file has only 2.");
}

}  // namespace
}  // namespace moat
