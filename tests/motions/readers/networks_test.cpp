#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "message_of.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record_channel.hpp"
#include "network_files.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace networks;

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), by);
}

class Networks : public testing::WrittenFiles {
 protected:
  [[nodiscard]] std::vector<RecordChannel> read(const std::string& text, const std::string& name = "a.txt") const {
    return read_channels(write(name, text));
  }
  [[nodiscard]] std::string refusal(const std::string& text, const std::string& name = "a.txt") const {
    return testing::message_of<FileError>([&] { (void)read(text, name); });
  }
  void expect_refused(const std::string& text, const std::string& words) const {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
};

void expect_wave(const RecordChannel& channel, double unit) {
  ASSERT_EQ(channel.samples.size(), wave.size());
  for (std::size_t i = 0; i < wave.size(); ++i) EXPECT_NEAR(channel.samples[i], unit * wave[i], 1e-12) << i;
}

TEST_F(Networks, ReadsKnet) {
  const std::vector<RecordChannel> channels = read(knet);
  ASSERT_EQ(channels.size(), 1u);
  const RecordChannel& channel = channels[0];
  // The mean of the counts is 100.
  EXPECT_DOUBLE_EQ(channel.samples[0], 0.0);
  EXPECT_DOUBLE_EQ(channel.samples[6], 0.01 * 2.0 * 6.0);
  EXPECT_DOUBLE_EQ(channel.samples[7], 0.01 * 2.0 * -21.0);
  EXPECT_DOUBLE_EQ(channel.step, 0.25);
  EXPECT_EQ(channel.station, "XYZ001");
  EXPECT_EQ(channel.component, "E-W");
  EXPECT_EQ(channel.azimuth, 90.0);
  EXPECT_EQ(channel.level, RecordLevel::raw);
  // 10:51:28 UTC on 24 January 2018.
  EXPECT_DOUBLE_EQ(channel.start.value(), 1516791088.0);
  // The peak is 42 gal.
  ASSERT_EQ(channel.warnings.size(), 1u);
  EXPECT_EQ(channel.warnings[0], "the header says a peak of 0.375 m/s^2, the samples reach 0.42 m/s^2: damaged?");
  EXPECT_TRUE(read(replaced(knet, "37.5", "42.0"))[0].warnings.empty());
  EXPECT_EQ(read(replaced(knet, "Max. Acc. (gal)   37.5", "Max Acc. (gal)    37.5"))[0].warnings, channel.warnings);
}

// 0.42 is any number from 0.415 to 0.425.
TEST_F(Networks, BelieveAPeakUpToHalfOfItsLastDigit) {
  for (const double peak : {0.4155, 0.4245, 0.4145, 0.4255}) {
    RecordChannel channel{.samples = {peak, -peak}};
    state_peak(channel, "0.42", 1.0);
    check_samples(channel);
    EXPECT_EQ(channel.warnings.empty(), std::abs(peak - 0.42) < 0.005) << peak;
  }
}

TEST_F(Networks, ReadsKikNetInTheBoreholeAndAtTheSurface) {
  const auto with = [&](const char* number) {
    return read(replaced(knet, "Dir.              E-W", "Dir.              " + std::string{number}))[0];
  };
  EXPECT_EQ(with("2").location, "borehole");
  EXPECT_EQ(with("5").location, "surface");
  EXPECT_EQ(with("4").azimuth, 0.0);
  EXPECT_TRUE(with("3").vertical);
  EXPECT_TRUE(with("6").vertical);
  expect_refused(replaced(knet, "Dir.              E-W", "Dir.              7"), "Dir. \"7\" is none of");
  expect_refused(replaced(knet, "2000(gal)/1000", "2000/1000"), "Scale Factor \"2000/1000\" is not of the form");
  expect_refused(replaced(knet, "     100 ", "     1x0 "), "line 18: \"1x0\" is not a number");
  expect_refused(replaced(knet, "       79 ", ""), "the file ends with 7 values, but frequency and duration make 8");
  expect_refused(replaced(knet, "4Hz", "0Hz"), "SAMPLING FREQ(HZ): 0Hz in the header is not allowed");
}

TEST_F(Networks, ReadsAfadInTheOrderOfItsColumns) {
  const std::vector<RecordChannel> channels = read(afad);
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_EQ(channels[0].azimuth, 90.0);
  EXPECT_EQ(channels[1].azimuth, 0.0);
  EXPECT_TRUE(channels[2].vertical);
  EXPECT_DOUBLE_EQ(channels[1].samples[1], -0.1325);
  EXPECT_DOUBLE_EQ(channels[1].stated_peak, 0.1325);
  EXPECT_DOUBLE_EQ(channels[2].step, 0.01);
  EXPECT_DOUBLE_EQ(channels[2].start.value(), 1500589858.5);
  EXPECT_EQ(channels[0].name, "a E-W");
  expect_refused(replaced(afad, ": 3\r", ": 4\r"), "announces NUMBER OF DATA: 4, but the file holds 3 rows");
  expect_refused(replaced(afad, "0.5 1.0 -1.0", "0.5 1.0"), "line 19: expected three numbers");
  expect_refused(replaced(afad, "0.5 1.0 -1.0", "0.5 1.0 -1.0 2.0"), "line 19: expected three numbers");
  expect_refused(replaced(afad, "U-D\r\n0.5", "\r\n0.5"), "expected the names of the columns");
}

TEST_F(Networks, ReadsCwaWithItsVerticalFirst) {
  const std::vector<RecordChannel> channels = read(cwa);
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_TRUE(channels[0].vertical);
  EXPECT_EQ(channels[1].azimuth, 0.0);
  EXPECT_EQ(channels[2].azimuth, 270.0) << "E(-)";
  EXPECT_DOUBLE_EQ(channels[0].samples[1], -0.0075);
  EXPECT_DOUBLE_EQ(channels[0].stated_peak, 0.0075);
  EXPECT_DOUBLE_EQ(channels[2].samples[4], -99.99125) << "columns may touch";
  EXPECT_DOUBLE_EQ(channels[0].step, 0.02);
  EXPECT_DOUBLE_EQ(channels[0].start.value(), 1517932229.0);
  for (const RecordChannel& channel : channels) EXPECT_EQ(channel.step, channels[0].step) << "one column of times";
  // Files of 1999 say neither origin nor zone.
  const RecordChannel old =
      read(replaced(replaced(cwa, "(GMT+08): 2018", ": 2018"), "#Earthquake Information\r\n\r\n", ""))[0];
  EXPECT_EQ(old.start, std::nullopt);
  EXPECT_EQ(old.event, "2018/02/06-23:50:29.000") << "two of one station are two";
  expect_refused(replaced(cwa, "     0.040 ", "     0.045 "),
                 "line 13: times are not even: 0.045 s is 0.005 s behind 2 steps of 0.02 s");
  expect_refused(replaced(cwa, "#AmplitudeUnit:  gal", "#AmplitudeUnit:  count"), "Only gal is read");
  expect_refused(replaced(cwa, "4F10.3", "3F10.3"), "differ in the number of columns");
  expect_refused(replaced(cwa, "U(+)", "U"), "is not of the form");
  expect_refused(replaced(cwa, "(sec): 0.1", "(sec): 120"), "makes 6000 rows, but the file holds 5");
}

TEST_F(Networks, ReadsGeoNet) {
  const std::string text =
      geonet_channel("S16W", "-12.25") + geonet_channel("S74E", "12") + geonet_channel("Down", "12.25");
  const std::vector<RecordChannel> channels = read(text);
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_EQ(channels[0].azimuth, 196.0);
  EXPECT_EQ(channels[1].azimuth, 106.0);
  EXPECT_TRUE(channels[2].vertical);
  expect_wave(channels[0], 1e-3);
  expect_wave(channels[2], -1e-3);
  EXPECT_DOUBLE_EQ(channels[0].step, 0.02);
  EXPECT_EQ(channels[0].station, "XYZ");
  EXPECT_DOUBLE_EQ(channels[0].start.value(), 1518470112.25) << "5 s of zeros before 21:15:17.25";
  EXPECT_EQ(channels[0].level, RecordLevel::corrected);
  const std::vector<RecordChannel> raw = read("Unc" + geonet_channel("N10E", "12.25").substr(1));
  EXPECT_EQ(raw[0].level, RecordLevel::uncorrected);
  EXPECT_EQ(raw[0].azimuth, 10.0);
  expect_refused(replaced(text, "    0.02", "    0.01"), "11 accelerations every 0.01 s make 0.11 s, but number 24");
  expect_refused(replaced(text, "S16W", "S96W"), "the component \"S96W  Longitudinal\" is none such as N80W or Up");
  expect_refused(text.substr(0, text.size() - 50), "the file ends before the last value of velocity");
  for (const std::string count : {"    1e30", "      -1"})
    expect_refused(replaced(text, "      11      12", "      11" + count), "it must be >= 0 and <= 1e9");
  expect_refused(geonet_channel("Up", "1") + "other\r\n", "expected the beginning of a channel");
}

TEST_F(Networks, ReadsCsmip) {
  const std::string text =
      csmip_channel("360 Deg", 360, "(8f10.5)") + csmip_channel("Up", 500, "(8F10.5)") + csmip_channel("H2", 1200, "");
  const std::vector<RecordChannel> channels = read(text + std::string(128, '\x1A'));
  ASSERT_EQ(channels.size(), 3u);
  for (const RecordChannel& channel : channels) expect_wave(channel, 0.01);
  EXPECT_EQ(channels[0].azimuth, 0.0);
  EXPECT_TRUE(channels[1].vertical);
  EXPECT_EQ(channels[2].azimuth, std::nullopt);
  EXPECT_EQ(channels[2].warnings, std::vector<std::string>{"no format is stated; read as 8 columns of 10 characters"});
  EXPECT_DOUBLE_EQ(channels[0].step, 0.02);
  EXPECT_EQ(channels[0].station, "WLT");
  EXPECT_DOUBLE_EQ(channels[0].start.value(), 1396066174.0);
  for (const auto& [written, start] : std::vector<std::pair<std::string, std::optional<double>>>{
           {"3/29/14, 04:09:34.0 PST", 1396066174.0 + 8 * 3600.0},
           {"3/29/14, 04:09:34.0 PDT", 1396066174.0 + 7 * 3600.0},
           {"3-29-14, 04:09:34.0 GMT (Q=5)", 1396066174.0},
           {"3/29/14, 04:09 UTC (Q=5)", std::nullopt},
           {"3/29/14, 04:09:34.0", std::nullopt},
           {"3/29/14, 04:09:34.0 HST", std::nullopt}})
    EXPECT_EQ(read(replaced(text, "3/29/14, 04:09:34.0 UTC (GPS)", written))[0].start, start) << written;
  // Old files are in capitals.
  const RecordChannel capitals = read(replaced(
      replaced(text, "Station Id. WLT     34.009N", "STATION NO. 24400   34.09N"), "Start time:", "TRIGGER TIME:"))[0];
  EXPECT_EQ(capitals.station, "24400");
  EXPECT_DOUBLE_EQ(capitals.start.value(), 1396066174.0);
  expect_refused(replaced(text, "Station Id. WLT     34.009N, 117.951W", ""), "expected \"Station No. 89146\"");
  EXPECT_EQ(read(csmip_channel("360 Deg", 900, "(8f10.5)"))[0].warnings,
            std::vector<std::string>{"azimuth 900 in the header, \"360 Deg\" in the text: text taken"});
  EXPECT_EQ(read(csmip_channel("90 Deg", 500, "(8f10.5)"))[0].azimuth, 90.0);
  EXPECT_TRUE(read(csmip_channel("somewhere", 600, "(8f10.5)"))[0].vertical);
  expect_refused(csmip_channel("somewhere", 900, "(8f10.5)"), "neither line 8 of the channel");
  expect_refused(replaced(text, "    11 points of accel", "     8 points of accel"),
                 "expected the velocities or \"/&\" behind 8 accelerations");
  expect_refused(replaced(text, "spaced at  .020", "spaced at  .010"),
                 "the step is 0.01 s here, and 0.02 s in value 61");
  expect_refused(replaced(text, "in cm/sec2", "in furlong"), "expected the unit");
  expect_refused(text.substr(0, text.size() - 60), "expected the end of the channel, \"/&\"");
}

TEST_F(Networks, ReadsSmc) {
  const std::vector<RecordChannel> channels = read(smc());
  ASSERT_EQ(channels.size(), 1u);
  expect_wave(channels[0], 0.01);
  EXPECT_DOUBLE_EQ(channels[0].step, 0.005);
  EXPECT_EQ(channels[0].azimuth, 0.0);
  EXPECT_EQ(channels[0].station, "San Francisco, 1295");
  EXPECT_DOUBLE_EQ(channels[0].stated_peak, 0.1225);
  EXPECT_DOUBLE_EQ(channels[0].start.value(), 624672255.5);
  EXPECT_TRUE(read(replaced(smc(), "        90       360", "       180       360"))[0].vertical);
  EXPECT_DOUBLE_EQ(read(replaced(smc(), "        90       360", "       180       360"))[0].samples[1], -0.015);
  // Without an angle the azimuth does not say that a component is horizontal.
  const std::string no_angle = replaced(smc(), "        90       360", "    -32768       360");
  EXPECT_EQ(read(no_angle)[0].azimuth, 0.0) << "by line 6";
  EXPECT_TRUE(read(replaced(no_angle, "component=    360", "component=     UP"))[0].vertical);
  EXPECT_EQ(read(replaced(no_angle, "component=    360", "component=       "))[0].component, "");
  EXPECT_EQ(read(replaced(smc(), "component=    360", "component=     UP"))[0].warnings,
            std::vector<std::string>{"component \"UP\" in the text, \"360\" in the header: header taken"});
  EXPECT_EQ(read(replaced(smc(), "component=", "COMPONENT="))[0].station, "San Francisco, 1295");
  expect_refused(replaced(smc(), "        90       360", "        45       360"), "inclined by 45 deg");
  expect_refused(replaced(smc(), " 2.0000000E+02", " 1.7000000E+38"), "the header states no rate");
  expect_refused(smc(8), "text follows the 8 values that the header announces");
  expect_refused(smc(2'000'000'000), "it must be >= 2 and <= 1e9");
  expect_refused(smc(12), "expected 4 values of acceleration in columns of 10 characters, but found 3");
  expect_refused(replaced(smc(), "|comment", "comment"), "expected a comment");
  EXPECT_EQ(read(replaced(smc(), "2 CORRECTED", "1 UNCORRECTED"))[0].level, RecordLevel::uncorrected);
}

TEST_F(Networks, ReadsBhrcAndRenadicAsUncorrected) {
  for (const bool is_chilean : {false, true}) {
    const std::string text =
        volume_channel("L", is_chilean) + volume_channel("V", is_chilean) + volume_channel("T", is_chilean);
    const std::vector<RecordChannel> channels = read(text);
    ASSERT_EQ(channels.size(), 3u);
    for (const RecordChannel& channel : channels) {
      expect_wave(channel, 0.980665);
      EXPECT_DOUBLE_EQ(channel.step, 0.005);
      EXPECT_EQ(channel.level, RecordLevel::uncorrected);
      EXPECT_EQ(channel.warnings, std::vector<std::string>{"this is the uncorrected record"});
    }
    EXPECT_EQ(channels[0].azimuth, is_chilean ? std::nullopt : std::optional{352.0});
    EXPECT_EQ(channels[2].azimuth, is_chilean ? std::nullopt : std::optional{82.0});
    EXPECT_TRUE(channels[1].vertical) << "the second";
    expect_refused(replaced(text, "=     11", "=     10"),
                   is_chilean ? "times are not even" : "expected \"/&\" behind the last value");
    expect_refused(replaced(text, "G/10", "G/12"), "expected the unit G/10");
    expect_refused(replaced(text, "G/10", "G/100"), "expected the unit G/10");
    expect_refused(replaced(text, is_chilean ? "CHAN  1: L" : "L\r\n", is_chilean ? "CHAN  1: Q" : "Q\r\n"),
                   "is none of L, V and T");
  }
  // In capitals, as older files are.
  const std::string site = "Ahar        Station   38 N  Azimuth L 352   T 82 ";
  const RecordChannel capitals =
      read(replaced(volume_channel("L", false), site, "AHAR        STATION   38 N  AZIMUTH L 352   T 82 "))[0];
  EXPECT_EQ(capitals.station, "AHAR");
  EXPECT_EQ(capitals.azimuth, 352.0);
  expect_refused(replaced(volume_channel("L", true), "  0.010-12.250", "  0.011-12.250"),
                 "line 28: times are not even");
}

TEST_F(Networks, ReadsUnamWithItsVerticalFirst) {
  const std::vector<RecordChannel> channels = read(unam);
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_TRUE(channels[0].vertical);
  EXPECT_EQ(channels[1].azimuth, 90.0);
  EXPECT_EQ(channels[2].azimuth, 0.0);
  EXPECT_DOUBLE_EQ(channels[1].samples[1], 0.04);
  EXPECT_DOUBLE_EQ(channels[2].step, 0.01);
  EXPECT_EQ(channels[0].station, "XYZ1");
  expect_refused(replaced(unam, "/3/3/3", "/6/3/3"), "do not make DURACION DEL REGISTRO");
  expect_refused(unam + "     1.000     2.000     3.000\r\n", "text follows the 3 rows of NUM. TOTAL DE MUESTRAS");
  expect_refused(
      replaced(replaced(unam, "/0.010/0.010/0.010", "/0.010/0.020/0.010"), "/0.03/0.03/0.03", "/0.03/0.06/0.03"),
      "INTERVALO DE MUESTREO differs between columns");
  expect_refused(replaced(unam, ": Gal", ": Cuentas"), "only Gal is read");
  expect_refused(replaced(unam, "3F10.3", "2F10.3"), "is no format of 3 columns");
  EXPECT_EQ(read(replaced(unam, "/V/N90E", "/V;-/N90E"))[0].warnings.back(),
            "of ORIENTACION \"V;-\" only \"V\" is used");
  expect_refused(replaced(unam, "/V/N90E", "/V/gone"), "ORIENTACION \"gone\" is none such as");
}

TEST_F(Networks, RefusesWhatIsNoRecordByName) {
  using namespace std::string_literals;
  const auto expect_no_record = [&](const std::string& text, const std::string& words) {
    const std::string message = testing::message_of<NotARecord>([&] { (void)read(text); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find("--record-unit"), std::string::npos) << message;
  };
  expect_no_record("Uncorrected Accelerogram Data             Processed\n" + lines(30),
                   "CSMIP V1: an uncorrected, digitised record. Take the file .V2");
  expect_no_record("II A001 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I\n" + lines(30), "USC: an uncorrected");
  expect_no_record(
      "Response and Fourier amplitude spectra (78 periods)\nCorrected accelerogram\nUncorrected Accelerogram Data\n",
      "CSMIP V3: a response spectrum, not a motion");
  expect_no_record("RAW ACCELERATION COUNTS\n" + lines(3), "raw counts of the recorder. Take the file V1 or V2");
  expect_no_record("PEER\nA\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01 SEC\n0 1\n",
                   "PEER VT2: velocity. Take the file of accelerations");
  expect_no_record("a letter\nto somebody\nwith 3 lines\n", "unknown format. Known are K-NET, AFAD, ESM (DYNA)");
  expect_no_record("000001D KEYA  BHZ"s + std::string(60, '\0'), "binary (miniSEED)");
  expect_no_record(std::string(304, '\0') + "\6\0\0\0"s + std::string(400, '\0'), "binary (SAC)");
  expect_no_record("\x89HDF\r\n\x1a\n"s + std::string(60, '\0'), "binary (HDF5)");
}

TEST_F(Networks, KnowsUnitsAsTheyAreWritten) {
  for (const char* name : {"gal", "cm/s2", "CM/S/S", "cm/sec/sec", "cm/sec2", "cm/s^2", "Gal"})
    EXPECT_EQ(acceleration_unit(name), 0.01) << name;
  EXPECT_EQ(acceleration_unit("mg"), 9.80665e-3);
  EXPECT_EQ(acceleration_unit("g/10"), 0.980665);
  EXPECT_EQ(acceleration_unit("mm/s/s"), 1e-3);
  EXPECT_EQ(acceleration_unit("in/s2"), 0.0254);
  EXPECT_EQ(acceleration_unit("ft/s2"), 0.3048);
  for (const char* name : {"m/s2", "m/s/s", "m/sec2", "M/S^2"}) EXPECT_EQ(acceleration_unit(name), 1.0) << name;
  for (const char* name : {"cm", "cm/s", "", "g/s2", "counts"})
    EXPECT_EQ(acceleration_unit(name), std::nullopt) << name;
}

TEST_F(Networks, AFileOfSeveralChannelsIsNoSingleMotion) {
  const auto file = write("a.txt", afad);
  const std::string message = testing::message_of<FileError>([&] { (void)read_motion(file); });
  EXPECT_NE(
      message.find("it holds 3 channels, E-W, N-S, U-D, and one is wanted. Take them together with read_record(file)"),
      std::string::npos)
      << message;
  // One horizontal beside a vertical channel is clear.
  EXPECT_EQ(
      read_motion(write("b.txt", csmip_channel("360 Deg", 360, "(8f10.5)") + csmip_channel("Up", 500, "(8F10.5)")))
          .name(),
      "b 360 Deg");
}

}  // namespace
}  // namespace moat
