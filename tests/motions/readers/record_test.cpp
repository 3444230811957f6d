// Records of several components, in files that the tests write.

#include "motions/readers/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "record_files.hpp"

namespace moat {
namespace {

using namespace units;

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

// Also where the file of the second component stands in front, or says its azimuth.
TEST_F(Records, AssumeThatTheSecondIsClockwiseOfTheFirst) {
  for (const auto& [one, two, x] : std::vector<std::tuple<std::string, std::string, double>>{{"T", "L", 90.0},
                                                                                             {"H2", "H1", 90.0},
                                                                                             {"T", "352", 82.0},
                                                                                             {"271", "T", 1.0},
                                                                                             {"T", "271", 1.0},
                                                                                             {"82", "L", 82.0},
                                                                                             {"HN2", "HN1", 90.0}}) {
    put("a.AT2", one);
    put("b.AT2", two);
    const Record record = read();
    EXPECT_EQ(record.frame.azimuth, x) << one << two;
    EXPECT_TRUE(record.frame.is_assumed) << one << two;
  }
}

TEST_F(Records, OfAnUnknownEarthquakeAreNotMixed) {
  put("A1-N.AT2", "?", "0.5 0.0", ".01", "Somewhere");
  put("A1-360.AT2", "?", "0.25 0.0", ".01", "Somewhere");
  put("A1-E.AT2", "?", "0.25 0.0", ".01", "Somewhere");
  expect_refused("A1-360.AT2 and A1-N.AT2 hold the same component of A1, and do not say of which earthquake.");
}

// As DYNA has them.
std::string dyna(const std::string& stream, const std::string& type, const std::string& start,
                 const std::string& values) {
  return "EVENT_NAME: test\nEVENT_ID: 1\nNETWORK: XY\nSTATION_CODE: ABC\nLOCATION:\n"
         "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20190728_" +
         start +
         "\nSAMPLING_INTERVAL_S: 1.0\nNDATA: " + std::to_string(std::count(values.begin(), values.end(), '\n')) +
         "\nSTREAM: " + stream + "\nUNITS: cm/s^2\nDATA_TYPE: " + type + "\n" + values;
}

// Processing puts 5 s of zeros in front; the next earthquake begins 100 s later.
TEST_F(Records, OfCorrectedAndUncorrectedFilesTakeTheCorrectedOnes) {
  (void)write("raw.HNE.ASC", dyna("HNE", "UNPROCESSED ACCELERATION", "160900", "1\n-1\n1\n-1\n1\n-1\n1\n-1\n"));
  (void)write("raw.HNN.ASC", dyna("HNN", "UNPROCESSED ACCELERATION", "160900", "2\n-2\n2\n-2\n2\n-2\n2\n-2\n"));
  (void)write("raw.HNZ.ASC", dyna("HNZ", "UNPROCESSED ACCELERATION", "160900", "2\n-2\n2\n-2\n2\n-2\n2\n-2\n"));
  (void)write("vol2.HNE.ASC", dyna("HNE", "ACCELERATION", "160855", "0\n0\n0\n0\n0\n3\n-3\n"));
  (void)write("vol2.HNN.ASC", dyna("HNN", "ACCELERATION", "160855", "0\n0\n0\n0\n0\n4\n-4\n"));
  Record record = read();
  EXPECT_EQ(record.name, "vol2");
  EXPECT_DOUBLE_EQ(record.first.samples()[5], 0.03);
  EXPECT_DOUBLE_EQ(record.second->samples()[5], 0.04);
  EXPECT_FALSE(record.vertical) << "it is not mixed in";
  for (const char* name : {"raw.HNE.ASC", "raw.HNN.ASC", "raw.HNZ.ASC"})
    EXPECT_TRUE(notes_have(name + std::string{" is left out: vol2.HNE.ASC holds this record, further processed."}))
        << name;
  EXPECT_EQ(read_record_folder(folder).size(), 2u);
  // The table may mix them.
  (void)write("records.csv",
              "file,record,component\nraw.HNE.ASC,R,x\nvol2.HNN.ASC,R,y\nraw.HNN.ASC,,out\nraw.HNZ.ASC,,out\n"
              "vol2.HNE.ASC,,out\n");
  EXPECT_DOUBLE_EQ(read().first.samples()[5], 0.01);
  std::filesystem::remove(folder / "records.csv");
  (void)write("next.HNE.ASC", dyna("HNE", "ACCELERATION", "161035", "3\n-3\n"));
  (void)write("next.HNN.ASC", dyna("HNN", "ACCELERATION", "161035", "4\n-4\n"));
  EXPECT_EQ(read_records(folder).size(), 2u);
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
