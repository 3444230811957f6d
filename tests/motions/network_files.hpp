// Small synthetic files in the layouts of the networks, with zeros and peaks whose places are known.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

namespace moat::networks {

template <class... Values>
std::string printed(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// `count` numbers of one format on lines of `per_line`.
inline std::string table(const std::vector<double>& values, const char* format, std::size_t per_line) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += printed(format, values[i]) + (i % per_line == per_line - 1 || i + 1 == values.size() ? "\r\n" : "");
  return text;
}

inline std::string lines(std::size_t count, const std::string& line = "Line of a synthetic file") {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += line + "\r\n";
  return text;
}

inline const std::vector<double> wave{0.0, 1.5, -12.25, 3.0, 0.0, 7.75, 0.0, 0.0, 0.0, 0.0, 0.0};

inline const std::string knet =
    "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\nDepth. (km)       30\n"
    "Mag.              6.2\nStation Code      XYZ001\nStation Lat.      41.5\nStation Long.     140.9\n"
    "Station Height(m) 39\nRecord Time       2018/01/24 19:51:43\nSampling Freq(Hz) 4Hz\nDuration Time(s)  2\n"
    "Dir.              E-W\nScale Factor      2000(gal)/1000\nMax. Acc. (gal)   37.5\n"
    "Last Correction   2018/01/24 19:51:43\nMemo.             \n"
    "     100      101      102      103      104      105      106       79 \n";

inline const std::string afad =
    "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : AYD\xDDN\r\n" + lines(4, "KEY : value") +
    "STATION ID              : 0921\r\n" + lines(4, "KEY : value") +
    "RECORD TIME             : 20/07/2017 22:30:58.500000 (GMT)\r\nNUMBER OF DATA          : 3\r\n"
    "SAMPLING INTERVAL (sec) : 0.01\r\nRAW PGA VALUES (gal)    : (N-S) 13.25 (E-W) 12.16 (U-D) 9.5\r\n" +
    lines(2, "Copyright") +
    "       E-W          N-S          U-D\r\n0.5 1.0 -1.0\r\n-12.16 -13.25 9.5\r\n1.0 2.0 3.0\r\n\r\n";

inline const std::string cwa =
    "#Earthquake Information\r\n\r\n#StationCode: EAS\r\n#StartTime(GMT+08): 2018/02/06-23:50:29.000\r\n"
    "#RecordLength(sec): 0.1\r\n#SampleRate(Hz): 50\r\n#AmplitudeUnit:  gal. DCoffset(corr)\r\n"
    "#AmplitudeMAX. U:    0.500~   -0.750\r\n#DataSequence: Time U(+); N(+); E(-)\r\n#Data: 4F10.3 \r\n"
    "     0.000     0.500     1.000     0.000\r\n     0.020    -0.750     0.000     2.000\r\n"
    "     0.040     0.000     0.000     0.000\r\n     0.060     0.000     0.000     0.000\r\n"
    "     0.080     0.000     0.000-9999.125\r\n";

inline std::string geonet_channel(const std::string& component, const std::string& peak) {
  std::vector<double> integers(40, 0.0), reals(60, 0.0);
  // The origin is 21:15:54.0; the buffer starts at 21:15:17.250, in values 9, 10, 19, 20, 39 and 40.
  const double origin[] = {2018, 2, 12, 21, 15, 540, 0, 0, 2018, 2};
  std::copy(std::begin(origin), std::end(origin), integers.begin());
  integers[18] = 12;
  integers[19] = 21;
  integers[38] = 15;
  integers[39] = 17250;
  integers[33] = static_cast<double>(wave.size());
  integers[34] = 12;  // velocities
  reals[21] = 5.0;
  reals[23] = 0.2;
  reals[24] = 0.005;
  reals[25] = 0.02;
  return "Corrected accelerogram 20180212_211554_XYZ_20 GNS Science\r\nSite XYZ      39 56 38S  176 35 04E\r\n" +
         lines(10) + "Component " + component + "  Longitudinal\r\nAcceleration:  peak " + peak +
         " mm/s/s at 0.04 sec\r\n" + lines(2) + table(integers, "%8.0f", 10) + table(reals, "%8.2f", 10) +
         table(wave, "%8.2f", 10) + table(std::vector<double>(12, 1.0), "%8.2f", 10);
}

inline std::string csmip_channel(const std::string& component, double azimuth, const std::string& format) {
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

inline std::string smc(std::size_t count = wave.size()) {
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

inline std::string volume_channel(const std::string& component, bool is_chilean) {
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

inline const std::string unam =
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

inline const std::string dyna =
    "EVENT_NAME: synthetic\nEVENT_ID: XY-2018\nNETWORK: XY\nSTATION_CODE: XYZ1\nLOCATION: 00\nSTREAM: HNE\n"
    "DATA_TYPE: ACCELERATION\nUNITS: cm/s^2\nSAMPLING_INTERVAL_S: 0.005\nNDATA: 3\n0.5\n-98.0665\n12.5\n";

inline std::string cosmos() {
  std::vector<double> integers(100, -999.0), reals(100, -999.0);
  integers[1] = 1;
  integers[2] = 4;
  reals[61] = 5.0;
  reals[62] = 0.055;
  return "Corrected acceleration (Format v01.20 with 13 text lines)\n" + lines(12) +
         " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" + table(integers, "%8.0f", 10) +
         " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" + table(reals, "%13.6f", 6) +
         "   1 Comment line(s) follow, each starting with a \"|\":\n|<SCNL>XYZ.BNZ.XY.--\n"
         "      11 acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(8F10.5)\n" +
         table(wave, "%10.5f", 8) + "End-of-data for Chan  1 acceleration\n";
}

inline std::string peer(const std::string& component = "000") {
  return "PEER NGA STRONG MOTION DATABASE RECORD\nKobe Japan, 1/16/1995, KJMA, " + component +
         "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .1 SEC\n  .1E-01 -.2E-01-.3E-01  .0E+00\n";
}

}  // namespace moat::networks
