// Synthetic files in the layout of the Engineering Strong Motion database, header format DYNA 1.2.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "base/error.hpp"
#include "motion_files.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

// 64 header lines. The tests replace values; an empty text takes the line away.
std::string esm(const std::map<std::string, std::string>& changed,
                const std::string& values = "0.5\n-98.0665\n12.5\n") {
  std::map<std::string, std::string> lines{{"SAMPLING_INTERVAL_S", " 0.005000"},
                                           {"NDATA", " 3"},
                                           {"UNITS", " cm/s^2"},
                                           {"DATA_TYPE", " ACCELERATION"},
                                           {"HEADER_FORMAT", " DYNA 1.2"},
                                           {"PGA_CM/S^2", " 98.0665"},
                                           {"VS30_M/S", ""},
                                           {"EVENT_TIME_HHMMSS", " 12:30:00"}};
  std::string text = "EVENT_NAME: synthetic\n";
  for (std::size_t i = lines.size() + 1; i < 64; ++i) text += "USER" + std::to_string(i) + ":\n";
  for (const auto& [key, value] : changed) lines[key] = value;
  for (const auto& [key, value] : lines)
    if (value != "no line") text += key + ":" + value + "\n";
  return text + values;
}

class Esm : public MotionFiles {
 protected:
  [[nodiscard]] std::string refusal(const std::string& text) const {
    const std::string message = message_of<FileError>([&] { (void)read_motion(write("A.ASC", text)); });
    const std::string name = path("A.ASC").string();
    return message.starts_with(name) ? message.substr(name.size()) : message;
  }
};

TEST_F(Esm, ReadsValuesIntervalAndNotes) {
  const GroundMotion motion = read_motion(write("IT.AMT.00.HNE.ASC", esm({})));
  EXPECT_EQ(motion.name(), "IT.AMT.00.HNE");
  EXPECT_DOUBLE_EQ(motion.time_step(), 0.005);
  ASSERT_EQ(motion.samples().size(), 3u);
  EXPECT_DOUBLE_EQ(motion.samples()[0], 0.005);
  EXPECT_DOUBLE_EQ(motion.samples()[1], -0.980665);
  EXPECT_EQ(motion.notes().front(), "EVENT_NAME: synthetic");
  // The first line and seven others have a value; the mean is far from 0.
  EXPECT_EQ(motion.notes().size(), 9u);
}

TEST_F(Esm, RefusesADurationThatStepAndCountDoNotMake) {
  const auto with = [&](const std::string& duration) {
    return esm({{"HEADER_FORMAT", " DYNA 1.0"}, {"DURATION_S", duration}});
  };
  for (const char* allowed : {"", " 0.015", " 0.010"})
    EXPECT_EQ(read_motion(write("A.ASC", with(allowed))).samples().size(), 3u) << allowed;
  EXPECT_EQ(refusal(with(" 0.5")), ": 3 values every 0.005 s make 0.015 s, but DURATION_S is 0.5.");
}

TEST_F(Esm, ReadsAnOlderHeaderAndUnprocessedAcceleration) {
  const std::string text = esm({{"HEADER_FORMAT", " DYNA 1.0"}, {"VS30_M/S", "no line"}});
  EXPECT_EQ(read_motion(write("A.ASC", text)).samples().size(), 3u);
  const std::string raw = esm({{"DATA_TYPE", " UNPROCESSED ACCELERATION"}});
  EXPECT_EQ(read_motion(write("A.ASC", raw)).samples().size(), 3u);
}

TEST_F(Esm, ReadsTheStationAndTheStream) {
  const std::string text = esm({{"HEADER_FORMAT", " DYNA 1.0"},
                                {"STREAM", " HNE"},
                                {"DATA_TYPE", " Acceleration"},
                                {"STATION_CODE", " ARS1"},
                                {"DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS", " 20190728_160919.870"}});
  const RecordChannel channel = read_channels(write("A.ASC", text))[0];
  EXPECT_EQ(channel.azimuth, 90.0);
  EXPECT_EQ(channel.station, "ARS1");
  EXPECT_DOUBLE_EQ(channel.start.value(), 1564330159.87);
  EXPECT_DOUBLE_EQ(channel.stated_peak, 0.980665);
  const std::string afad = esm({{"HEADER_FORMAT", " DYNA 1.0"},
                                {"STREAM", " HNZ"},
                                {"DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS", " 28/07/2019 16:09:19.870"}});
  EXPECT_DOUBLE_EQ(read_channels(write("A.ASC", afad))[0].start.value(), 1564330159.87);
  EXPECT_TRUE(read_channels(write("A.ASC", afad))[0].vertical);
}

TEST_F(Esm, RefusesAMissingKey) {
  for (const char* key : {"SAMPLING_INTERVAL_S", "NDATA", "UNITS", "DATA_TYPE"})
    for (const char* value : {"no line", ""}) {
      const std::map<std::string, std::string> changed{{key, value}, {"HEADER_FORMAT", " DYNA 1.0"}};
      EXPECT_EQ(refusal(esm(changed)), std::string{": the header does not give "} + key +
                                           ". Fetch the file again, or add the line \"" + key + ": ...\".");
    }
}

TEST_F(Esm, RefusesAnotherUnitOrQuantity) {
  EXPECT_EQ(refusal(esm({{"UNITS", " g"}})),
            ": the header says UNITS: g. Only cm/s^2 is read; take the file of accelerations, or convert it.");
  EXPECT_EQ(refusal(esm({{"UNITS", " cm/s"}})),
            ": the header says UNITS: cm/s. Only cm/s^2 is read; take the file of accelerations, or convert it.");
  for (const char* type : {"VELOCITY", "ACCELERATION RESPONSE SPECTRUM"})
    EXPECT_EQ(refusal(esm({{"DATA_TYPE", std::string{" "} + type}})),
              std::string{": the header says DATA_TYPE: "} + type +
                  ". Only histories of ACCELERATION are read; take the file of accelerations.");
}

TEST_F(Esm, RefusesWrongCounts) {
  EXPECT_EQ(refusal(esm({{"VS30_M/S", "no line"}})),
            ": a header of format DYNA 1.2 has 64 lines, but this one has 63. The file was edited or cut; fetch it "
            "again.");
  EXPECT_EQ(refusal(esm({}, "1.0\n2.0\n")),
            ": the header announces NDATA: 3 values, but the file holds 2. The file is damaged or was cut; fetch it "
            "again.");
  for (const char* count : {"1", "3.0", "-3", "three"})
    EXPECT_EQ(refusal(esm({{"NDATA", std::string{" "} + count}})),
              std::string{": NDATA: "} + count + " in the header is not allowed; it must be a whole number >= 2.");
}

TEST_F(Esm, RefusesWrongNumbers) {
  for (const char* interval : {"0", "-0.005", "fast"})
    EXPECT_EQ(refusal(esm({{"SAMPLING_INTERVAL_S", std::string{" "} + interval}})),
              std::string{": SAMPLING_INTERVAL_S: "} + interval +
                  " in the header is not allowed; it must be a number > 0 s.");
  EXPECT_EQ(refusal(esm({}, "1.0\n2.0 3.0\n4.0\n")),
            ", line 66: \"2.0 3.0\" is not a number. Behind the header every line holds one acceleration.");
  EXPECT_EQ(refusal(esm({}, "1.0\nUNITS: g\n4.0\n")),
            ", line 66: \"UNITS: g\" is not a number. Behind the header every line holds one acceleration.");
}

}  // namespace
}  // namespace moat
