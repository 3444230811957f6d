// Recorded accelerograms. They are not part of moat: the environment variable MOAT_RECORDS names a folder with them.

#include "motions/readers/read_motion.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "base/text/text_file.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

using namespace units;

class RealRecords : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MOAT_RECORDS");
    if (!folder) GTEST_SKIP() << "set MOAT_RECORDS to a folder with PEER AT2 files to run this test";
    folder_ = folder;
  }
  std::filesystem::path folder_;
};

TEST_F(RealRecords, AllRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder_}) {
    if (upper_case(entry.path().extension().string()) != ".AT2") continue;
    ++count;
    const GroundMotion motion = read_motion(entry.path());
    EXPECT_GT(motion.peak_acceleration(), 0.01 * g) << motion.description();
    EXPECT_LT(motion.peak_acceleration(), 3.0 * g) << motion.description();
    EXPECT_GT(motion.duration(), 5.0) << motion.description();
  }
  EXPECT_GT(count, 0) << "no AT2 file in " << folder_;
}

struct KnownPeaks {
  const char* file;
  double time_step;
  std::size_t samples;
  double pga_g, pgv_cm_s, pgd_cm;
};

// Determined by an independent program from the same files: trapezoidal integration, peaks at the samples.
constexpr KnownPeaks known_peaks[] = {
    {"RSN1161_KOCAELI_GBZ000.AT2", 0.005, 5600, 0.2608, 44.61, 41.1},
    {"RSN1161_KOCAELI_GBZ270.AT2", 0.005, 5600, 0.1438, 32.63, 29.8},
    {"RSN1108_KOBE_KBU000.AT2", 0.01, 3200, 0.2758, 55.28, 15.2},
    {"RSN1108_KOBE_KBU-UP.AT2", 0.01, 3200, 0.4520, 18.58, 7.3},
    {"RSN982_NORTHR_JEN022.AT2", 0.005, 5721, 0.4105, 111.43, 44.6},
    {"RSN803_LOMAP_WVC270.AT2", 0.005, 7998, 0.3312, 64.89, 37.8},
    {"RSN803_LOMAP_WVC000.AT2", 0.005, 7998, 0.2575, 42.05, 24.3},
    {"NGA_no_1063_RRS228.AT2", 0.01, 1991, 0.8252, 160.07, 29.6},
    {"RSN1106_KOBE_KJM000.AT2", 0.02, 7500, 0.8342, 91.07, 21.1},
    {"RSN6_IMPVALL.I_I-ELC180.AT2", 0.01, 5372, 0.2808, 30.93, 8.7},
};

TEST_F(RealRecords, HaveTheirKnownPeaks) {
  int count = 0;
  for (const KnownPeaks& known : known_peaks) {
    if (!std::filesystem::exists(folder_ / known.file)) continue;
    ++count;
    const GroundMotion motion = read_motion(folder_ / known.file);
    EXPECT_EQ(motion.time_step(), known.time_step) << known.file;
    EXPECT_EQ(motion.samples().size(), known.samples) << known.file;
    EXPECT_NEAR(motion.peak_acceleration() / g, known.pga_g, 0.5e-4) << known.file;
    // Half a unit in the last place of the table; the peak between samples may lie a little higher.
    const double pgv = motion.peak_velocity() / (cm / s);
    EXPECT_GT(pgv, known.pgv_cm_s - 0.006) << known.file;
    EXPECT_LT(pgv, known.pgv_cm_s * 1.002 + 0.006) << known.file;
    EXPECT_NEAR(motion.peak_displacement() / cm, known.pgd_cm, 0.06 + 0.002 * known.pgd_cm) << known.file;
  }
  if (count < std::ssize(known_peaks))
    GTEST_SKIP() << "the folder of MOAT_RECORDS has " << count << " of " << std::size(known_peaks)
                 << " records with known peaks; these were compared";
}

}  // namespace
}  // namespace moat
