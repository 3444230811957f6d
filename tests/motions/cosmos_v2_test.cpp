// Synthetic files in the layout of the COSMOS format, version 1.20.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "motion_files.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// A file of the format; the tests replace one part at a time.
struct SyntheticFile {
  int text_lines = 13;
  std::vector<int> integers = std::vector<int>(100, -999);
  std::vector<double> reals = std::vector<double>(100, -999.0);
  std::string integer_line = " 100 Integer-header values follow on  10 lines, Format= (10I8)";
  std::string real_line = " 100 Real-header values follow on  17 lines, Format= (6F13.6)";
  std::string comments = "   2 Comment line(s) follow, each starting with a \"|\":\n|<PROCESS>\n| synthetic\n";
  std::string data_line = "      11 acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(8F10.5)";
  std::vector<double> values{0.0, 1.5, -250.25, 3.0, -4.0, 5.0, -6.0, 7.0, 8.0, -9.0, 0.125};
  std::string end = "End-of-data for Chan  1 acceleration\n";

  SyntheticFile() {
    integers[0] = 2;
    integers[1] = 1;
    integers[2] = 4;
    reals[61] = 5.0;
    reals[62] = 0.055;
  }
  [[nodiscard]] std::string text() const {
    std::string text = "Corrected acceleration    (Format v01.20 with 13 text lines) Src: synthetic\n";
    for (int i = 2; i <= text_lines; ++i) text += "Line " + std::to_string(i) + " of a synthetic file\n";
    text += integer_line + "\n";
    for (std::size_t i = 0; i < integers.size(); ++i) text += printed("%8.0f", integers[i]) + (i % 10 == 9 ? "\n" : "");
    text += real_line + "\n";
    for (std::size_t i = 0; i < reals.size(); ++i)
      text += printed("%13.6f", reals[i]) + (i % 6 == 5 || i == 99 ? "\n" : "");
    text += comments + data_line + "\n";
    for (std::size_t i = 0; i < values.size(); ++i)
      text += printed("%10.5f", values[i]) + (i % 8 == 7 || i + 1 == values.size() ? "\n" : "");
    return text + end;
  }
};

class Cosmos : public MotionFiles {
 protected:
  [[nodiscard]] GroundMotion read(const SyntheticFile& file) const {
    return read_motion(write("RECORD.V2", file.text()));
  }
  [[nodiscard]] std::string refusal(const SyntheticFile& file) const {
    const std::string message = message_of<FileError>([&] { (void)read(file); });
    const std::string name = path("RECORD.V2").string();
    return message.starts_with(name) ? message.substr(name.size()) : message;
  }
};

TEST_F(Cosmos, ReadsValuesIntervalAndNotes) {
  const SyntheticFile file;
  const GroundMotion motion = read(file);
  EXPECT_EQ(motion.name(), "RECORD");
  EXPECT_DOUBLE_EQ(motion.time_step(), 0.005);
  ASSERT_EQ(motion.samples().size(), file.values.size());
  for (std::size_t i = 0; i < file.values.size(); ++i)
    EXPECT_DOUBLE_EQ(motion.samples()[i], 0.01 * file.values[i]) << i;
  ASSERT_EQ(motion.notes().size(), 14u) << "the mean is far from 0";
  EXPECT_EQ(motion.notes()[12], "Line 13 of a synthetic file");
}

TEST_F(Cosmos, TakesTheUnitByItsNumber) {
  const std::vector<std::pair<int, double>> units{{2, 9.80665}, {4, 0.01}, {10, 0.01}, {11, 9.80665e-3}};
  for (const auto& [number, si] : units) {
    SyntheticFile file;
    file.integers[2] = number;
    const std::string two_digits = (number < 10 ? "0" : "") + std::to_string(number);
    file.data_line = "      11 acceleration pts, approx    0 secs, units=name (" + two_digits + "), Format=(8f10.5)";
    EXPECT_DOUBLE_EQ(read(file).samples()[1], 1.5 * si) << number;
  }
}

TEST_F(Cosmos, RefusesAUnitThatIsNotThatOfItsNumber) {
  SyntheticFile file;
  file.data_line = "      11 acceleration pts, approx    0 secs, units=g(04), Format=(8f10.5)";
  EXPECT_NE(refusal(file).find("the unit is \"G\", but its number 4 stands for cm/s^2"), std::string::npos)
      << refusal(file);
}

TEST_F(Cosmos, TakesAnUnknownAzimuthFromLine9) {
  const std::string text = SyntheticFile{}.text(), line = "Line 9 of a synthetic file",
                    site = "Line 5 of a synthetic file";
  const auto with = [&](std::string words, const std::string& code) {
    std::string changed = text;
    changed.replace(changed.find(line), line.size(), words);
    changed.replace(changed.find(site), site.size(), code);
    return read_channels(write("RECORD.V2", changed))[0];
  };
  const RecordChannel channel =
      with("Sta Cha:  1: 340 deg (Rcrdr Chan  1) Location: Up", "Statn No: 1 Code:CE-J2236 Town");
  EXPECT_EQ(channel.azimuth, 340.0);
  EXPECT_EQ(channel.station, "CE-J2236");
  EXPECT_EQ(with("STA CHAN  1:  90 DEG LOCATION: ROOF", "STATN NO: 1 CODE:CE-J2236").azimuth, 90.0);
  EXPECT_EQ(with("STA CHAN  1:  90 DEG LOCATION: ROOF", "STATN NO: 1 CODE:CE-J2236").station, "CE-J2236");
  EXPECT_EQ(with("Location of the channel 1: Up", "").component, "");
}

TEST_F(Cosmos, ReadsColumnsThatTouchAndEveryKindOfFormat) {
  SyntheticFile file;
  file.values = {};
  file.data_line = "       4 uncor. accel. pts, approx    0 secs, units=cm/sec2(04), Format=(4F8.3)";
  file.end = "-100.000-200.000 300.000-400.125\nEnd-of-data\n";
  file.reals[62] = -999.0;
  EXPECT_DOUBLE_EQ(read(file).samples()[3], -4.00125);
  file.data_line = "       4 acceleration pts, approx    0 secs, units=cm/sec2(04), Format=(8F, Format=(2E14.6)";
  file.end = " -1.000000E+02  2.000000D+02\n  3.000000E-01 -4.000000E+00\nEnd-of-data\n";
  EXPECT_DOUBLE_EQ(read(file).samples()[1], 2.0);
  EXPECT_DOUBLE_EQ(read(file).samples()[2], 0.003);
  file.data_line = "       2 acceleration pts, approx    0 secs, units=cm/sec2(04), Format=(I6)";
  file.end = "  -100\n   200\nEnd-of-data\n";
  EXPECT_DOUBLE_EQ(read(file).samples()[0], -1.0);
}

TEST_F(Cosmos, TakesALengthWithAndWithoutTheLastInterval) {
  SyntheticFile file;
  for (const double length : {0.055, 0.050, -999.0}) {
    file.reals[62] = length;
    EXPECT_NO_THROW((void)read(file)) << length;
  }
  file.reals[62] = 11.0;
  EXPECT_EQ(refusal(file),
            ", line 46: 11 values at intervals of 5 ms last 0.055 s, but value 63 of the real header, the "
            "length, is 11 s.");
}

TEST_F(Cosmos, RefusesWrongCounts) {
  SyntheticFile file;
  file.text_lines = 12;
  EXPECT_NE(refusal(file).find(", line 14: expected the line \" 100 Integer-header values follow on"),
            std::string::npos)
      << refusal(file);
  file = {};
  file.integer_line = " 110 Integer-header values follow on  10 lines, Format= (10I8)";
  EXPECT_NE(refusal(file).find(", line 25: expected 10 values of the Integer header in columns of 8"),
            std::string::npos)
      << refusal(file);
  file = {};
  file.values.push_back(1.0);
  EXPECT_NE(refusal(file).find(", line 48: expected 3 values of acceleration in columns of 10 characters, but found 4"),
            std::string::npos)
      << refusal(file);
  file = {};
  file.values.pop_back();
  EXPECT_NE(refusal(file).find(", line 48: expected 3 values of acceleration"), std::string::npos) << refusal(file);
  file = {};
  file.comments = "   1 Comment line(s) follow, each starting with a \"|\":\n|<PROCESS>\n| synthetic\n";
  EXPECT_NE(refusal(file).find("expected the line \" 4000 acceleration pts"), std::string::npos) << refusal(file);
  file.comments = "   2 Comment line(s) follow, each starting with a \"|\":\n|<PROCESS>\n";
  EXPECT_NE(refusal(file).find("expected 2 lines of comment"), std::string::npos) << refusal(file);
  file = {};
  file.integers.resize(1);
  file.integer_line = "   1 Integer-header values follow on   1 lines, Format= (10I8)";
  EXPECT_NE(refusal(file).find("the Integer header has 1 values; 3 are needed."), std::string::npos) << refusal(file);
}

TEST_F(Cosmos, RefusesAnotherQuantityOrUnit) {
  SyntheticFile file;
  file.integers[1] = 2;
  EXPECT_NE(refusal(file).find("value 2 of the integer header is 2; only 1, acceleration, is read."), std::string::npos)
      << refusal(file);
  file = {};
  file.integers[2] = 2;
  EXPECT_NE(refusal(file).find("the unit is number 4 here, but value 3 of the integer header is 2."), std::string::npos)
      << refusal(file);
  file = {};
  file.integers[2] = 50;
  file.data_line = "      11 raw accel. pts, approx    0 secs, units=counts (50),Format=(8F10.5)";
  EXPECT_NE(refusal(file).find("unit number 50 is not one of acceleration"), std::string::npos) << refusal(file);
  file = {};
  file.data_line = "      11 acceleration pts, approx    0 secs, Format=(8F10.5)";
  EXPECT_NE(refusal(file).find("expected the unit with its number"), std::string::npos) << refusal(file);
}

TEST_F(Cosmos, RefusesWrongIntervalsFormatsAndNumbers) {
  SyntheticFile file;
  for (const double interval : {-999.0, 0.0}) {
    file.reals[61] = interval;
    EXPECT_NE(refusal(file).find("the interval of the samples"), std::string::npos) << refusal(file);
  }
  for (const char* format : {"(8F10)", "(8A10)", "(0F10.5)", "8F10.5", "(I8.2)"}) {
    file = {};
    file.data_line = std::string{"      11 acceleration pts, approx    0 secs, units=cm/sec2(04),Format="} + format;
    EXPECT_NE(refusal(file).find("expected a Fortran format"), std::string::npos) << refusal(file);
  }
  file = {};
  file.values = {};
  file.data_line = "       2 acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(2F10.5)";
  file.reals[62] = -999.0;
  file.end = "   1.00000      x.xx\n";
  EXPECT_EQ(refusal(file), ", line 47: \"x.xx\" is not a number.");
  file.end = "   1.00000       200\n";
  EXPECT_NE(refusal(file).find("\"200\" has no decimal point"), std::string::npos) << refusal(file);
  file.data_line = "       1 acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(2F10.5)";
  EXPECT_NE(refusal(file).find("1 values are not enough"), std::string::npos) << refusal(file);
}

TEST_F(Cosmos, RefusesACutFile) {
  const SyntheticFile file;
  const std::string text = file.text();
  for (std::size_t i = 1; i < text.size(); i += 97) {
    const auto cut = write("CUT.V2", text.substr(0, text.size() - i));
    EXPECT_FALSE(message_of<FileError>([&] { (void)read_motion(cut); }).empty()) << i;
  }
  SyntheticFile no_end;
  no_end.end = "";
  EXPECT_NE(refusal(no_end).find("expected \"End-of-data\""), std::string::npos) << refusal(no_end);
  SyntheticFile two;
  two.end += "text\n";
  EXPECT_NE(refusal(two).find("expected \"(Format v01.20 with 13 text lines)\""), std::string::npos) << refusal(two);
}

TEST_F(Cosmos, ReadsSeveralSeries) {
  SyntheticFile one, two, three;
  one.integers[53] = 45;
  one.reals[63] = -250.25;
  one.end = "/&  ----------  End of data for channel  1  ----------\n\n";
  two.integers[53] = 401;
  three.integers[53] = 2000;
  three.comments = "   1 Comment line(s) follow, each starting with a \"|\":\n|<SCNL>BMR.BNZ.AK.--    <AUTH> 2019\n";
  two.comments = three.comments;  // The channel BNZ may point down.
  const std::vector<RecordChannel> channels =
      read_channels(write("a.v1", one.text() + two.text() + three.text() + "\n"));
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_EQ(channels[0].azimuth, 45.0);
  EXPECT_DOUBLE_EQ(channels[0].stated_peak, 2.5025);
  EXPECT_TRUE(channels[1].vertical);
  EXPECT_DOUBLE_EQ(channels[1].samples[1], -0.015) << "down becomes up";
  EXPECT_TRUE(channels[2].vertical) << "by the channel BNZ";
  EXPECT_EQ(channels[2].station + channels[2].network, "BMRAK");
}

// 0 and -999 are no azimuths.
TEST_F(Cosmos, TakesAnUnknownAzimuthFromTheText) {
  for (const int code : {0, -999, 2000}) {
    SyntheticFile file;
    file.integers[53] = code;
    std::string text = file.text();
    const std::string old = "Line 9 of a synthetic file";
    EXPECT_EQ(read_channels(write("a.v1", text))[0].azimuth, std::nullopt);
    text.replace(text.find(old), old.size(), "Sta Chan  1: 340 deg (Rcrdr Chan  1)");
    EXPECT_EQ(read_channels(write("a.v1", text))[0].azimuth, 340.0);
  }
}

TEST_F(Cosmos, LeavesOutOtherSeriesByName) {
  SyntheticFile one, two;
  two.integers[2] = 25;
  two.data_line = "      11 acceleration pts, approx    0 secs, units=deg/sec (25),Format=(8F10.5)";
  const std::vector<RecordChannel> channels = read_channels(write("a.v1", one.text() + two.text()));
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_NE(channels[0].warnings[0].find("channel 2 is left out: unit number 25"), std::string::npos);
}

}  // namespace
}  // namespace moat
