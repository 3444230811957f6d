// Real files of the networks. They are not part of moat: the environment variable MOAT_FORMATS names a folder with
// them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "message_of.hpp"
#include "motions/readers/record.hpp"
#include "motions/readers/record_channel.hpp"

namespace moat {
namespace {

class NetworkSamples : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MOAT_FORMATS");
    if (!folder) GTEST_SKIP() << "set MOAT_FORMATS to the folder with files of the networks to run this test";
    folder_ = folder;
  }
  std::filesystem::path folder_;
};

struct Sample {
  const char* file;
  double unit, step;
  std::size_t count;
  std::vector<double> peaks;  ///< In the unit; the sign of the largest sample, 0 if it was not noted.
};

// Found by an independent program from the same files.
const std::vector<Sample> samples{
    {"knet_AOM0011801241951.EW", 0.01, 0.01, 10200, {4.0781}},
    {"knet_AOM0011801241951.NS", 0.01, 0.01, 10200, {4.9544}},
    {"knet_AOM0011801241951.UD", 0.01, 0.01, 10200, {2.2401}},
    {"kiknet_AICH040010061330.EW2", 0.01, 0.005, 28600, {3.8959}},
    {"afad_20170720223109_0921.txt", 0.01, 0.01, 28683, {13.200332, 12.163827, 9.840572}},
    {"cwa_1-EAS.dat", 0.01, 0.02, 6000, {0.837, 2.273, 1.017}},
    {"geonet_20180212_211557_WPWS_20.V2A", 1e-3, 0.02, 5800, {41.6, 194.0, 27.3}},
    {"geonet_20161113_110300_HSES_20.V1A", 1e-3, 0.005, 65536, {2394.8, 2584.4, 1589.9}},
    {"csmip_CE89146.V2", 0.01, 0.005, 12000, {77.28034, 20.52918, 44.20005}},
    {"csmip_BadHeader.V2", 0.01, 0.005, 12000, {77.28034, 20.52918, 44.20005}},
    {"csmip_CIWLT.V2", 0.01, 0.02, 15050, {82.58426, 115.8455, 69.66225}},
    {"cosmos_Cosmos12TimeSeriesTest.v1", 0.01, 0.01, 7000, {161.9618}},
    {"cosmos_AKBMR_BNZ.V2c", 0.01, 0.005, 42000, {6.851512}},
    {"esm_HI.ARS1.HNE.ASC", 0.01, 0.005, 19128, {0.300022}},
    {"smc_0111a.smc", 0.01, 0.005, 6001, {104.41}},
    {"bhrc_5520-1.V1", 0.980665, 0.005, 15616, {1.94316, 0.998684, 2.61898}},
    {"renadic_cuya0911131.v1", 0.980665, 0.005, 5652, {1.319, 0.638, 1.293}},
};

TEST_F(NetworkSamples, HaveTheirKnownStepsAndPeaks) {
  for (const auto& [file, unit, step, count, peaks] : samples) {
    const std::vector<RecordChannel> channels = read_channels(folder_ / file);
    ASSERT_EQ(channels.size(), peaks.size()) << file;
    EXPECT_EQ(channels[0].samples.size(), count) << file;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      double peak = 0.0;
      for (const double sample : channels[i].samples) peak = std::max(peak, std::abs(sample));
      // Half a unit of the last digit of the list.
      EXPECT_NEAR(peak / unit, peaks[i], 0.51e-4) << file << " " << i;
      EXPECT_DOUBLE_EQ(channels[i].step, step) << file;
      for (const std::string& warning : channels[i].warnings)
        EXPECT_EQ(warning.find("damaged"), std::string::npos) << warning;
      const bool states_it = !std::string_view{file}.starts_with("bhrc");
      EXPECT_EQ(channels[i].stated_peak > 0.0, states_it) << file;
    }
  }
}

TEST_F(NetworkSamples, OthersAreRefusedByName) {
  for (const auto& [file, words] : std::map<std::string, std::string>{{"csmip_CE89146.V1", "CSMIP V1"},
                                                                      {"csmip_CE89146.V3", "CSMIP V3"},
                                                                      {"smc_891018_0444a.smc", "times are not even"}}) {
    const std::string message = testing::message_of<NotARecord>([&] { (void)read_channels(folder_ / file); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
}

TEST_F(NetworkSamples, BecomeRecordsInRightHandedFrames) {
  std::map<std::string, Record> records;
  for (const Record& record : read_records(folder_)) records.emplace(record.name, record);
  // Azimuths of x; the vertical is first in CWA, second in BHRC, CSMIP and RENADIC.
  for (const auto& [name, azimuth] : std::map<std::string, double>{{"knet_AOM0011801241951", 90.0},
                                                                   {"afad_20170720223109_0921", 90.0},
                                                                   {"cwa_1-EAS", 90.0},
                                                                   {"geonet_20180212_211557_WPWS_20", 196.0},
                                                                   {"geonet_20161113_110300_HSES_20", 10.0},
                                                                   {"csmip_CIWLT", 90.0},
                                                                   {"bhrc_5520-1", 82.0},
                                                                   {"renadic_cuya0911131", 90.0}}) {
    ASSERT_TRUE(records.contains(name)) << name;
    const Record& record = records.at(name);
    EXPECT_TRUE(record.second && record.vertical) << name;
    EXPECT_EQ(record.frame.azimuth, azimuth) << name;
    EXPECT_EQ(record.frame.is_assumed, name.starts_with("renadic")) << name;
    EXPECT_FALSE(record.frame.is_mixed) << name;
  }
  EXPECT_FALSE(records.contains("cosmos_AKBMR_BNZ")) << "vertical alone";
}

}  // namespace
}  // namespace moat
