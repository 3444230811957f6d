// The building on friction pendulums of ./moat bench experiments: its filter, its fits, and the measured tests.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <moat.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "../../support/in_folder.hpp"
#include "benchmark_building.hpp"
#include "experiments/buffalo_model.hpp"
#include "experiments/buffalo_tests.hpp"
#include "message_of.hpp"

namespace moat::experiments {
namespace {

using namespace units;

constexpr double step = 1.0 / 256.0;

// Both ways: no delay, and the gain |H|^2 = 1/(1 + (tan(pi f_c h)/tan(pi f h))^4) of one way squared.
TEST(BuffaloFilter, KeepsThePhaseAndSquaresTheGain) {
  const std::size_t count = 256 * 200, middle = count / 2;
  for (const double frequency : {0.075, 0.15, 0.3, 2.0}) {
    History history;
    for (std::size_t i = 0; i < count; ++i)
      history.push_back(5.0 + std::sin(2.0 * std::numbers::pi * frequency * static_cast<double>(i) * step));
    const History filtered = high_passed_both_ways(history);
    ASSERT_EQ(filtered.size(), count);
    const double ratio = std::tan(std::numbers::pi * 0.15 * step) / std::tan(std::numbers::pi * frequency * step);
    for (std::size_t i = middle; i < middle + 2560; ++i)
      ASSERT_NEAR(filtered[i], (history[i] - 5.0) / (1.0 + std::pow(ratio, 4.0)), 1e-8) << frequency;
  }
}

TEST(BuffaloHistories, AreComparedByPeakAndCorrelation) {
  EXPECT_EQ(largest({1.0, -3.0, 2.0}), 3.0);
  EXPECT_NEAR(correlation({1.0, 2.0, 3.0}, {12.0, 14.0, 16.0}), 1.0, 1e-15);
  EXPECT_NEAR(correlation({1.0, 2.0, 3.0}, {2.0, 1.0, 2.0}), 0.0, 1e-15);
}

// A test whose "measured" histories are those of the model with known parameters.
BuffaloTest made(bool isolated, int level, double strength, const SteelFrame& frame, const PendulumFriction& friction) {
  GroundMotion table = near_fault_pulse({.pulse_period = 0.7 * s, .time_step = step * s, .quiet_after = 3 * s});
  BuffaloTest test{
      .name = "made", .isolated = isolated, .level = level, .table = table.scaled_to_pga(strength * g), .measured = {}};
  test.measured = computed(test, frame, friction);
  if (!isolated) test.measured.isolators.assign(test.table.samples().size(), 0.0);
  return test;
}

TEST(BuffaloFits, FindTheParametersOfMadeTests) {
  const SteelFrame frame{.stiffness_over_mass = {500.0, 320.0, 300.0},
                         .damping_ratio = 0.03,
                         .yield_drift = 0.012,
                         .hardening_ratio = 0.4};
  const PendulumFriction friction{.slow = 0.03, .fast = 0.06};
  const std::vector<BuffaloTest> tests{made(false, 1, 0.2, frame, friction), made(false, 3, 0.6, frame, friction),
                                       made(true, 1, 0.3, frame, friction), made(true, 3, 0.6, frame, friction),
                                       // Levels that are predicted have no part in the fits.
                                       made(false, 2, 0.4, {}, {}),
                                       made(true, 4, 0.4, {}, {.slow = 0.09, .fast = 0.1})};
  const SteelFrame found = identified_frame(tests);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(found.stiffness_over_mass[i] / frame.stiffness_over_mass[i], 1.0, 0.01) << i;
  EXPECT_NEAR(found.damping_ratio, 0.03, 0.003);
  EXPECT_NEAR(found.yield_drift, 0.012, 0.0003);
  EXPECT_NEAR(found.hardening_ratio, 0.4, 0.01);
  const PendulumFriction of_pendulums = identified_friction(tests, frame);
  EXPECT_NEAR(of_pendulums.slow, 0.03, 0.001);
  EXPECT_NEAR(of_pendulums.fast, 0.06, 0.001);
  // They are deterministic, and keep the start where no test identifies.
  EXPECT_EQ(identified_friction(tests, frame).slow, of_pendulums.slow);
  EXPECT_NEAR(identified_friction({tests.back()}, frame).slow, PendulumFriction{}.slow, 1e-15);
  EXPECT_LT(unexplained(tests[0], computed(tests[0], found, {})), 0.01);
}

class BuffaloFiles : public testing::InFolder {};

TEST_F(BuffaloFiles, OfAnotherLayoutAreRefused) {
  std::ofstream{folder / "fpgm111s1.csv"} << "time_s,a\n0,1\n0.0039,2\n";
  const std::string message = testing::message_of<FileError>([&] { read_buffalo_tests(folder); });
  EXPECT_NE(message.find("must have six columns, and a name such as"), std::string::npos) << message;
  std::filesystem::remove(folder / "fpgm111s1.csv");
  std::ofstream{folder / "fpgm111.csv"} << "t,a,b,c,d,e\n0,1,0,0,0,0\n0.0039,2,0,0,0,0\n";
  EXPECT_THROW(read_buffalo_tests(folder), FileError);
}

// 0.01 g of offset and a drift of the base are no motion.
TEST_F(BuffaloFiles, AreReadWithoutTheirOffsets) {
  std::ofstream file{folder / "fbgm152s4.csv"};
  file << "time_s,table_acceleration_g,base_in,floor1_in,floor2_in,floor3_in\n";
  for (int i = 0; i < 2560; ++i) file << 0.0039 * i << ",0.01,0.5,1,2,4\n";
  file.close();
  std::ofstream{folder / "notes.txt"} << "another file";
  const std::vector<BuffaloTest> tests = read_buffalo_tests(folder);
  ASSERT_EQ(tests.size(), 1u);
  EXPECT_EQ(tests[0].name, "fbgm152s4");
  EXPECT_FALSE(tests[0].isolated);
  EXPECT_FALSE(tests[0].identifies());
  EXPECT_EQ(tests[0].table.time_step(), step);
  EXPECT_LT(tests[0].table.peak_acceleration().si(), 1e-12);
  EXPECT_LT(largest(tests[0].measured.isolators), 1e-9);
  for (const History& drift : tests[0].measured.drifts) EXPECT_LT(largest(drift), 1e-12);
}

// Measured peaks as others found them in these files, in inches, and the targets.
TEST(BuffaloMeasurements, AreMetByTheIdentifiedModel) {
  const std::string folder = testing::folder_of_experiment("buffalo");
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "MOAT_EXPERIMENTS has no folder buffalo: the shake-table tests are left out.";
  const std::map<std::string, double> peaks{
      {"fpgm111s1", 0.74}, {"fpgm111s2", 2.25}, {"fpgm152s1", 1.07}, {"fpgm152s2", 2.58}, {"fpgm162s1", 1.18},
      {"fpgm162s3", 2.60}, {"fpgm171s1", 2.04}, {"fpgm171s2", 4.07}, {"fpgm172s1", 0.67}, {"fpgm172s2", 1.71}};
  std::size_t compared = 0;
  for (const BuffaloTest& test : read_buffalo_tests(folder)) {
    const auto known = peaks.find(test.name);
    if (known == peaks.end()) continue;
    ++compared;
    const double measured = largest(test.measured.isolators);
    EXPECT_NEAR(measured / inch, known->second, 0.011) << test.name;
    EXPECT_NEAR(largest(computed(test, {}, {}).isolators) / measured, 1.0, 0.15) << test.name;
  }
  EXPECT_EQ(compared, peaks.size());
}

}  // namespace
}  // namespace moat::experiments
