// Small synthetic files in the layouts of the networks, with zeros and peaks whose places are known.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/error.hpp"
#include "message_of.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record_channel.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

template <class... Values>
std::string printed(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// `count` numbers of one format on lines of `per_line`.
std::string table(const std::vector<double>& values, const char* format, std::size_t per_line) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += printed(format, values[i]) + (i % per_line == per_line - 1 || i + 1 == values.size() ? "\r\n" : "");
  return text;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), by);
}

std::string lines(std::size_t count, const std::string& line = "Line of a synthetic file") {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += line + "\r\n";
  return text;
}

const std::vector<double> wave{0.0, 1.5, -12.25, 3.0, 0.0, 7.75, 0.0, 0.0, 0.0, 0.0, 0.0};

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

const std::string knet =
    "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\nDepth. (km)       30\n"
    "Mag.              6.2\nStation Code      XYZ001\nStation Lat.      41.5\nStation Long.     140.9\n"
    "Station Height(m) 39\nRecord Time       2018/01/24 19:51:43\nSampling Freq(Hz) 4Hz\nDuration Time(s)  2\n"
    "Dir.              E-W\nScale Factor      2000(gal)/1000\nMax. Acc. (gal)   37.5\n"
    "Last Correction   2018/01/24 19:51:43\nMemo.             \n"
    "     100      101      102      103      104      105      106       79 \n";

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

const std::string afad =
    "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : AYD\xDDN\r\n" + lines(4, "KEY : value") +
    "STATION ID              : 0921\r\n" + lines(4, "KEY : value") +
    "RECORD TIME             : 20/07/2017 22:30:58.500000 (GMT)\r\nNUMBER OF DATA          : 3\r\n"
    "SAMPLING INTERVAL (sec) : 0.01\r\nRAW PGA VALUES (gal)    : (N-S) 13.25 (E-W) 12.16 (U-D) 9.5\r\n" +
    lines(2, "Copyright") +
    "       E-W          N-S          U-D\r\n0.5 1.0 -1.0\r\n-12.16 -13.25 9.5\r\n1.0 2.0 3.0\r\n\r\n";

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

const std::string cwa =
    "#Earthquake Information\r\n\r\n#StationCode: EAS\r\n#StartTime(GMT+08): 2018/02/06-23:50:29.000\r\n"
    "#RecordLength(sec): 0.1\r\n#SampleRate(Hz): 50\r\n#AmplitudeUnit:  gal. DCoffset(corr)\r\n"
    "#AmplitudeMAX. U:    0.500~   -0.750\r\n#DataSequence: Time U(+); N(+); E(-)\r\n#Data: 4F10.3 \r\n"
    "     0.000     0.500     1.000     0.000\r\n     0.020    -0.750     0.000     2.000\r\n"
    "     0.040     0.000     0.000     0.000\r\n     0.060     0.000     0.000     0.000\r\n"
    "     0.080     0.000     0.000-9999.125\r\n";

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
  expect_refused(replaced(cwa, "     0.040 ", "     0.045 "),
                 "line 13: times are not even: 0.045 s is 0.005 s behind 2 steps of 0.02 s");
  expect_refused(replaced(cwa, "#AmplitudeUnit:  gal", "#AmplitudeUnit:  count"), "Only gal is read");
  expect_refused(replaced(cwa, "4F10.3", "3F10.3"), "differ in the number of columns");
  expect_refused(replaced(cwa, "U(+)", "U"), "is not of the form");
  expect_refused(replaced(cwa, "(sec): 0.1", "(sec): 120"), "makes 6000 rows, but the file holds 5");
}

std::string geonet_channel(const std::string& component, const std::string& peak) {
  std::vector<double> integers(40, 0.0), reals(60, 0.0);
  const double date[] = {2018, 2, 12, 21, 15, 540};
  std::copy(std::begin(date), std::end(date), integers.begin());
  integers[33] = static_cast<double>(wave.size());
  integers[34] = 12;  // velocities
  reals[21] = 5.0;
  reals[24] = 0.005;
  reals[25] = 0.02;
  return "Corrected accelerogram 20180212_211554_XYZ_20 GNS Science\r\nSite XYZ      39 56 38S  176 35 04E\r\n" +
         lines(10) + "Component " + component + "  Longitudinal\r\nAcceleration:  peak " + peak +
         " mm/s/s at 0.04 sec\r\n" + lines(2) + table(integers, "%8.0f", 10) + table(reals, "%8.2f", 10) +
         table(wave, "%8.2f", 10) + table(std::vector<double>(12, 1.0), "%8.2f", 10);
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
  EXPECT_DOUBLE_EQ(channels[0].start.value(), 1518470149.0) << "5 s before the stated 21:15:54";
  EXPECT_EQ(channels[0].level, RecordLevel::corrected);
  const std::vector<RecordChannel> raw = read("Unc" + geonet_channel("N10E", "12.25").substr(1));
  EXPECT_EQ(raw[0].level, RecordLevel::uncorrected);
  EXPECT_EQ(raw[0].azimuth, 10.0);
  expect_refused(replaced(text, "S16W", "S96W"), "the component \"S96W  Longitudinal\" is none such as N80W or Up");
  expect_refused(text.substr(0, text.size() - 50), "the file ends before the last value of velocity");
  expect_refused(geonet_channel("Up", "1") + "other\r\n", "expected the beginning of a channel");
}

std::string csmip_channel(const std::string& component, double azimuth, const std::string& format) {
  std::vector<double> integers(100, -999.0), reals(100, -999.0);
  integers[26] = azimuth;
  reals[60] = 0.02;
  reals[65] = -12.25;
  std::string text = lines(23);
  const auto line = [&](const std::string& words) { text += words + "\r\n"; };
  text = "";
  line("Corrected accelerogram   15481673      Chan  1");
  line("Uncorrected Accelerogram Data             Processed: 04/30/14");
  text += lines(2);
  line("15481673.CI.WLT     Start time:  3/29/14, 04:09:34.0 UTC (GPS)");
  line("Station Id. WLT     34.009N, 117.951W");
  text += lines(1);
  line("Chan  1: " + component);
  text += lines(17);
  text += table(integers, "%5.0f", 16) + table(reals, "%10.4f", 8);
  line("    11 points of accel data equally spaced at  .020 sec, in cm/sec2. " + format);
  text += table(wave, "%10.5f", 8);
  line("     1 points of veloc data equally spaced at  .020 sec, in cm/sec.  (8f10.7)");
  line(" 1.0000000");
  line("/&  ----------  End of data for channel  1  ----------");
  return text;
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

std::string smc(std::size_t count = wave.size()) {
  std::vector<double> integers(48, -32768.0), reals(50, 0.17e39);
  const double known[] = {-32768, 1989, 291, 0, 4, 15, 500};
  std::copy(std::begin(known), std::end(known), integers.begin());
  integers[12] = 90;
  integers[13] = 360;
  integers[15] = 1;
  integers[16] = static_cast<double>(count);
  reals[1] = 200.0;
  reals[29] = 7.75;
  reals[31] = -12.25;
  std::string values;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    const int tens = std::abs(wave[i]) >= 10.0 ? 1 : 0;
    values += printed("%7.4fE+%d", wave[i] / (tens ? 10.0 : 1.0), tens) + (i % 8 == 7 ? "\r\n" : "");
  }
  return "2 CORRECTED ACCELEROGRAM    \r\n*\r\nSAF0A\r\n     1989  10  18\r\nMoment Mag=\r\n"
         "station = San Francisco, 1295    component=    360\r\nepicentral dist =\r\ninst type\r\n*\r\n*\r\n*\r\n" +
         table(integers, "%10.0f", 8) + table(reals, "%15.7E", 5) + "|comment\r\n" + values + "\r\n";
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
  expect_refused(replaced(smc(), "        90       360", "        45       360"), "inclined by 45 deg");
  expect_refused(replaced(smc(), " 2.0000000E+02", " 1.7000000E+38"), "the header states no rate");
  expect_refused(smc(8), "text follows the 8 values that the header announces");
  expect_refused(smc(12), "expected 4 values of acceleration in columns of 10 characters, but found 3");
  expect_refused(replaced(smc(), "|comment", "comment"), "expected a comment");
  EXPECT_EQ(read(replaced(smc(), "2 CORRECTED", "1 UNCORRECTED"))[0].level, RecordLevel::uncorrected);
}

std::string volume_channel(const std::string& component, bool is_chilean) {
  std::string text = is_chilean ? lines(5) + "CUYA\r\nCHAN  1: " + component +
                                      "        (STA CHN:  1)\r\nUNIVERSIDAD DE CHILE - RENADIC\r\n" + lines(2)
                                : "* VOL1DS FILE:  1/01\r\n" + lines(3) + component + "\r\n\r\nCOMP " + component +
                                      "1\r\nAhar        Station   38 N  Azimuth L 352   T 82 \r\n" + lines(2);
  text += is_chilean ? "NO. OF POINTS =     11  RECORD LENGTH = 0.055 SEC\r\nUNITS OF UNCOR ACCEL ARE SEC AND G/10.    "
                       " MAX  =  1.225 G, AT  0.010 SEC\r\n"
                     : "NO. OF POINTS =     11      DURATION =   .055\r\nUNITS ARE SECONDS AND G/10\r\n";
  text += lines(15);
  if (!is_chilean) return text + table(wave, "%13.6E", 10) + "/&\r\n";
  std::vector<double> pairs;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    pairs.push_back(0.005 * static_cast<double>(i));
    pairs.push_back(wave[i]);
  }
  return text + table(pairs, "%7.3f", 10) + "/&  ----------  END OF DATA FOR CHANNEL 1  ----------\r\n";
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
    expect_refused(replaced(text, is_chilean ? "CHAN  1: L" : "L\r\n", is_chilean ? "CHAN  1: Q" : "Q\r\n"),
                   "is none of L, V and T");
  }
  expect_refused(replaced(volume_channel("L", true), "  0.010-12.250", "  0.011-12.250"),
                 "line 28: times are not even");
}

const std::string unam =
    lines(6) +
    "=== ARCHIVO ESTANDAR DE ACELERACION ===\r\nCLAVE DE LA ESTACION : XYZ1\r\n"
    "ORIENTACION C1-C6 (rumbo;orientacion) : /V/N90E/N00E\r\nINTERVALO DE MUESTREO, C1-C6 (s) : /0.010/0.010/0.010\r\n"
    "NUM. TOTAL DE MUESTRAS, C1-C6 : /3/3/3\r\nDURACION DEL REGISTRO (s), C1-C6 : /0.03/0.03/0.03\r\n"
    "ACEL. MAX.(Gal), C1-C6 : /2.500/4.000/1.000\r\nUNIDADES DE LOS DATOS : Gal\r\nFACTOR DE DECIMACION : 1\r\n"
    "FORMATO DATOS : 3F10.3\r\n" +
    lines(3) +
    "DATOS DE ACELERACION:\r\n---------+---------+---------+\r\n"
    "   CANAL-1   CANAL-2   CANAL-3\r\n---------+---------+---------+\r\n"
    "     2.500     0.000     1.000\r\n     0.000     4.000    -1.000\r\n    -2.500    -4.000     0.000\r\n";

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
  expect_refused(replaced(unam, ": Gal", ": Cuentas"), "only Gal is read");
  expect_refused(replaced(unam, "3F10.3", "2F10.3"), "is no format of 3 columns");
  expect_refused(replaced(unam, "/V/N90E", "/V/west"), "ORIENTACION \"west\" is none such as");
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
