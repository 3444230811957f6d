// Records of several components, in files that the tests write.

#include "motions/readers/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record_folder.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;

class Records : public testing::WrittenFiles {
 protected:
  /// A file of PEER with values in g.
  void put(const std::string& name, const std::string& component, const std::string& values = "0.0 0.1 -0.1",
           const std::string& step = ".01", const std::string& station = "Kobe Japan, 1/16/1995, KJMA") const {
    (void)write(name, "PEER NGA STRONG MOTION DATABASE RECORD\n" + station + ", " + component +
                          "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= " +
                          std::to_string(std::count(values.begin(), values.end(), ' ') + 1) + ", DT= " + step +
                          " SEC\n" + values + "\n");
  }
  [[nodiscard]] Record read(const RecordOptions& options = {}) const { return read_record({folder}, options); }
  [[nodiscard]] std::string refusal(const RecordOptions& options = {}) const {
    return testing::message_of<FileError>([&] { (void)read_records(folder, options); });
  }
  void expect_refused(const std::string& words, const RecordOptions& options = {}) const {
    const std::string message = refusal(options);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
  [[nodiscard]] bool notes_have(const std::string& words) const {
    return std::ranges::any_of(record_folder_notes(), [&](const std::string& note) {
      return note.find(folder.string() + ": " + words) != std::string::npos;
    });
  }
};

/// In g.
std::vector<double> values_of(const GroundMotion& motion) {
  std::vector<double> values(motion.samples().begin(), motion.samples().end());
  for (double& value : values) value /= standard_gravity;
  return values;
}

TEST_F(Records, XIsTheChannelWhoseAzimuthIs90DegreesLarger) {
  for (const auto& [one, two, x] :
       std::vector<std::tuple<std::string, std::string, std::string>>{{"0", "90", "90"},
                                                                      {"270", "360", "0"},
                                                                      {"228", "318", "318"},
                                                                      {"90", "360", "90"},
                                                                      {"N", "E", "90"},
                                                                      {"S16W", "S74E", "196"}}) {
    put("a1.AT2", one, "0.5 0.0");
    put("a2.AT2", two, "0.25 0.0");
    const Record record = read();
    EXPECT_EQ(record.frame.azimuth, std::stod(x)) << one << two;
    EXPECT_FALSE(record.frame.is_mixed);
    // Physically: east and north of both channels are those of the frame's axes.
    const double a = record.frame.azimuth * deg, first = values_of(record.first)[0],
                 second = values_of(*record.second)[0];
    const double east = first * std::sin(a) - second * std::cos(a), north = first * std::cos(a) + second * std::sin(a);
    const std::vector<double> azimuths = record.frame.channels;
    EXPECT_NEAR(east * std::sin(azimuths[0] * deg) + north * std::cos(azimuths[0] * deg), 0.5, 1e-12);
    EXPECT_NEAR(east * std::sin(azimuths[1] * deg) + north * std::cos(azimuths[1] * deg), 0.25, 1e-12);
  }
}

TEST_F(Records, ResolvesChannelsThatAreNotSquare) {
  put("LCN260.AT2", "260", "1.0 0.0 0.3");
  put("LCN345.AT2", "345", "0.0 1.0 0.7");
  put("LCN-UP.AT2", "UP", "0.1 0.2 0.3");
  const Record record = read();
  EXPECT_EQ(record.name, "LCN");
  EXPECT_EQ(record.frame.azimuth, 90.0);
  EXPECT_TRUE(record.frame.is_mixed);
  // East and north by hand: E = -0.174311 s_345 - 0.969616 s_260, N = 0.988570 s_345 - 0.259808 s_260.
  const std::vector<double> east = values_of(record.first), north = values_of(*record.second);
  EXPECT_NEAR(east[0], -0.969616, 1e-6);
  EXPECT_NEAR(east[1], -0.174311, 1e-6);
  EXPECT_NEAR(north[0], -0.259808, 1e-6);
  EXPECT_NEAR(north[1], 0.988570, 1e-6);
  EXPECT_NEAR(east[2], 0.3 * -0.969616 + 0.7 * -0.174311, 1e-6);
  EXPECT_NEAR(values_of(*record.vertical)[2], 0.3, 1e-12);
  EXPECT_TRUE(notes_have("260 and 345 deg are 85 deg apart: resolved exactly."));
  EXPECT_TRUE(record.plan().vertical.has_value());
  // Turned by the azimuth of x: the resultant stays.
  const Record turned = read({.x_azimuth = 30 * deg});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(std::hypot(values_of(turned.first)[i], values_of(*turned.second)[i]), std::hypot(east[i], north[i]),
                1e-12);
  EXPECT_NEAR(values_of(turned.first)[1], -0.174311 * 0.5 + 0.988570 * std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(values_of(*turned.second)[1], 0.174311 * std::sqrt(0.75) + 0.988570 * 0.5, 1e-6);
}

TEST_F(Records, TurnsSquareChannelsToAnAzimuth) {
  put("A000.AT2", "0", "1.0 0.0");
  put("A090.AT2", "90", "0.0 1.0");
  const Record same = read({.x_azimuth = 90 * deg});
  EXPECT_FALSE(same.frame.is_mixed);
  const Record north = read({.x_azimuth = 0 * deg});
  EXPECT_TRUE(north.frame.is_mixed);
  // x north, y west.
  EXPECT_NEAR(values_of(north.first)[0], 1.0, 1e-12);
  EXPECT_NEAR(values_of(*north.second)[1], -1.0, 1e-12);
}

TEST_F(Records, RefusesParallelAndTooManyComponents) {
  put("A000.AT2", "0");
  put("A030.AT2", "30");
  expect_refused("A000.AT2 and A030.AT2 of KJMA are no pair at right angles: 0 and 30 deg are 30 deg apart.");
  put("A090.AT2", "90");
  expect_refused("KJMA has 3 horizontal components (0, 30, 90)");
  EXPECT_NE(refusal().find((folder / "records.csv").string()), std::string::npos);
}

TEST_F(Records, TakesTheBetterOfTwo) {
  put("A000.AT2", "0", "0.5 0.0 0.0");
  put("A360.AT2", "360", "0.25 0.0 0.0 0.0");
  put("A090.AT2", "90");
  EXPECT_EQ(values_of(*read().second)[0], 0.25);
  EXPECT_TRUE(notes_have("A000.AT2 is left out: A360.AT2 holds the same component, and is longer."));
}

TEST_F(Records, OfOneComponentServeModelsOnALine) {
  put("A000.AT2", "0");
  put("B-UP.AT2", "UP", "0.0 0.1", ".01", "Somewhere, 1/1/2000, Else");
  const std::vector<Record> records = read_records(folder);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_FALSE(records[0].second);
  EXPECT_EQ(
      testing::message_of<InputError>([&] { (void)records[0].plan(); }),
      "Record \"A\": it has one horizontal component. A model in plan needs two; a model on a line takes .first.");
  EXPECT_TRUE(notes_have("B-UP.AT2 is left out: its header says \"UP\", and Else has no horizontal component."));
}

TEST_F(Records, AssumeAzimuthsOfLAndT) {
  put("L.AT2", "L", "1.0 0.0");
  put("T.AT2", "T", "0.0 1.0");
  const Record record = read();
  EXPECT_TRUE(record.frame.is_assumed);
  EXPECT_EQ(record.frame.azimuth, 90.0);
  EXPECT_EQ(values_of(record.first)[1], 1.0) << "T is 90 degrees clockwise of L";
  EXPECT_TRUE(notes_have("azimuths of \"KJMA\" are assumed"));
}

// As K-NET has them: starts 14:00:00 and 14:00:00.02.
std::string knet(const std::string& component, const std::string& start, const std::string& counts,
                 int frequency = 100) {
  const auto count = std::count(counts.begin(), counts.end(), ' ') + 1;
  return "Origin Time       2018/01/24 19:51:00\nLat.\nLong.\nDepth. (km)\nMag.\nStation Code      XYZ001\nStation "
         "Lat.\nStation Long.\n"
         "Station Height(m)\nRecord Time       2018/01/24 " +
         start + "\nSampling Freq(Hz) " + std::to_string(frequency) + "Hz\nDuration Time(s)  " +
         std::to_string(static_cast<double>(count) / frequency) + "\nDir.              " + component +
         "\nScale Factor      980.665(gal)/1\nMax. Acc. (gal)\nLast Correction\nMemo.\n" + counts + "\n";
}

TEST_F(Records, DelayComponentsThatStartLater) {
  (void)write("XYZ.EW", knet("E-W", "14:00:00", "1 -1 1 -1"));
  (void)write("XYZ.NS", knet("N-S", "14:00:00.02", "1 -1"));
  const Record record = read();
  EXPECT_EQ(record.name, "XYZ");
  EXPECT_EQ(values_of(record.first), (std::vector<double>{1, -1, 1, -1}));
  EXPECT_EQ(values_of(*record.second), (std::vector<double>{0, 0, 1, -1}));
  EXPECT_TRUE(notes_have("XYZ N-S starts 0.02 s later: zeros stand in front of it."));
  (void)write("XYZ.NS", knet("N-S", "14:00:00.018", "1 -1"));
  expect_refused(
      "XYZ N-S starts 0.018 s later than another component, which is more than 1000 s, or no "
      "whole number of steps of 0.01 s.");
  (void)write("XYZ.NS", knet("N-S", "14:00:00", "1 -1", 50));
  EXPECT_EQ(values_of(*read().second), (std::vector<double>{1, 0, -1, 0}));
  (void)write("XYZ.NS", knet("N-S", "14:00:00", "1 -1", 60));
  expect_refused("no whole ratio");
}

TEST_F(Records, BoreholeAndSurfaceAreTwo) {
  (void)write("ABC.EW1", knet("2", "14:00:00", "1 -1 1 -1"));
  (void)write("ABC.NS1", knet("1", "14:00:00", "1 -1 1 -1"));
  (void)write("ABC.EW2", knet("5", "14:00:00", "1 -1 1 -1"));
  (void)write("ABC.NS2", knet("4", "14:00:00", "1 -1 1 -1"));
  const std::vector<Record> records = read_records(folder);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].name + ", " + records[1].name, "ABC borehole, ABC surface");
}

TEST_F(Records, TableDecides) {
  put("a.AT2", "0", "0.5 0.0");
  put("b.AT2", "90", "0.25 0.0");
  (void)write("c.txt", "0.125\n0.0\n");
  (void)write("readme.md", "Records\nof a test\nhere\n");
  (void)write("study.db", std::string(2000, '\1'));
  const auto table = [&](const std::string& rows) {
    (void)write("records.csv", "file,channel,record,component,azimuth,unit,step,sign\n" + rows);
  };
  table("a.AT2,1,Kobe,x,,,,-1\nb.AT2,1,Kobe,y,,g,.01,\nc.txt,,Kobe,z,,mg,0.01,\n");
  Record record = read();
  EXPECT_EQ(record.name, "Kobe");
  EXPECT_NEAR(values_of(record.first)[0], -0.5, 1e-12) << "mirrored by the user";
  EXPECT_NEAR(values_of(*record.second)[0], 0.25, 1e-12);
  EXPECT_NEAR(values_of(*record.vertical)[0], 0.125e-3, 1e-12);
  EXPECT_TRUE(notes_have("readme.md is left out: unknown format."));
  EXPECT_TRUE(notes_have("study.db is left out: this is no plain text"));
  table("a.AT2,,,,45,,,\nb.AT2,,,,315,,,\n");
  record = read();
  EXPECT_EQ(record.frame.azimuth, 45.0);
  EXPECT_TRUE(notes_have("c.txt is left out: plain text does not say its unit"));
  for (const auto& [rows, problem] : std::vector<std::pair<std::string, std::string>>{
           {"a.AT2,,,,45\n", "is not of this form"},
           {"a.AT2,,,q,,,,\n", "names no component"},
           {"a.AT2,,,,400,,,\n", "an azimuth outside 0 to 360 deg"},
           {"a.AT2,,,,,,,2\n", "a sign that is neither 1 nor -1"},
           {"a.AT2,,,,,bananas,,\n", "a unit that is not known"},
           {"a.AT2,,,,,,0,\n", "a step that is not > 0 s"},
           {"a.AT2,,,,x,,,\n", "has no number as azimuth"},
           {"d.AT2,,,,,,,\n", "names a file that is not there"},
           {"a.AT2,,,,,gal,,\n", "has another unit than the file, g"},
           {"a.AT2,,,,,,.02,\n", "has another step than the file"},
           {"a.AT2,,K,x,,,,\nb.AT2,,K,x,,,,\n", "K has two components x, a.AT2 and b.AT2"}}) {
    table(rows);
    expect_refused(problem);
  }
  expect_refused("no such file", {.table = folder / "none.csv"});
}

TEST_F(Records, WrittenTableReadsThemAgain) {
  put("a.AT2", "260", "1.0 0.0 0.3");
  put("b.AT2", "345", "0.0 1.0 0.7");
  put("c.AT2", "DWN", "0.0 0.5 0.0");
  put("d.AT2", "L", "0.5 0.0", ".01", "Elsewhere, 1/1/2000, X");
  put("e.AT2", "T", "0.25 0.0", ".01", "Elsewhere, 1/1/2000, X");
  const std::vector<Record> before = read_records(folder);
  write_record_table(folder / "records.csv", folder);
  const std::vector<Record> after = read_records(folder);
  ASSERT_EQ(before.size(), 2u);
  ASSERT_EQ(after.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(values_of(before[i].first), values_of(after[i].first));
    EXPECT_EQ(values_of(*before[i].second), values_of(*after[i].second));
    EXPECT_EQ(before[i].frame.azimuth, after[i].frame.azimuth);
  }
  EXPECT_NEAR(values_of(*before[0].vertical)[1], -0.5, 1e-12) << "down is turned up";
}

TEST_F(Records, ReadFilesThatAreNamed) {
  put("a.AT2", "0");
  put("b.AT2", "90");
  put("c.AT2", "90", "0.0 0.1", ".01", "Elsewhere, 1/1/2000, X");
  EXPECT_TRUE(read_record({folder / "a.AT2", folder / "b.AT2"}).second);
  const std::string message = testing::message_of<FileError>([&] {
    (void)read_record({folder / "a.AT2", folder / "c.AT2"});
  });
  EXPECT_NE(message.find("expected the files of one record, but found 2: a, c."), std::string::npos) << message;
  (void)write("readme.md", "Records\nof a test\nhere\n");
  EXPECT_THROW((void)read_record({folder / "readme.md"}), NotARecord);
}

TEST_F(Records, DamagedFilesAreRefused) {
  put("a.AT2", "0");
  (void)write("b.AT2", "PEER\nA, B, 90\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 9, DT= .01 SEC\n0.1 0.2\n");
  expect_refused("the header announces NPTS = 9 values, but the file holds 2");
}

TEST_F(Records, ReadsColumnsOfTextAsOneRecord) {
  const auto file = write("newhall.txt", "% FN and FP\n0.0 0.5\n0.25 0.0\n-0.125 1.0\n");
  const std::string message = testing::message_of<FileError>([&] { (void)read_record({file}); });
  EXPECT_NE(message.find("the first does not grow, so it is no time. Name them: --record-columns x,y"),
            std::string::npos)
      << message;
  const Record record = read_record({file}, {.text = {.unit = 1 * g, .step = 0.02 * s, .columns = "x,y"}});
  EXPECT_EQ(values_of(record.first), (std::vector<double>{0.0, 0.25, -0.125}));
  EXPECT_EQ(values_of(*record.second), (std::vector<double>{0.5, 0.0, 1.0}));
  EXPECT_EQ(record.name, "newhall");
}

}  // namespace
}  // namespace moat
