// The high-pass filter against its own formula for the frequency response.

#include "motions/high_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double time_step = 0.005;
constexpr double corner = 2.0;

/// The filter's impulse response to one sample of 1 at `at`, until it has decayed.
std::vector<double> impulse_response(int order, std::size_t at = 0) {
  std::vector<double> samples(8000, 0.0);
  samples[at] = 1.0;
  const GroundMotion answer = high_passed(GroundMotion{"impulse", time_step, samples}, corner * Hz, order);
  return {answer.samples().begin(), answer.samples().end()};
}

std::complex<double> response_at(const std::vector<double>& impulse, double frequency) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < impulse.size(); ++i)
    sum += impulse[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency * time_step * static_cast<double>(i));
  return sum;
}

class HighPassOfOrder : public ::testing::TestWithParam<int> {};

TEST_P(HighPassOfOrder, HasTheAmplitudeOfButterworth) {
  const int order = GetParam();
  const std::vector<double> impulse = impulse_response(order);
  for (const double frequency : {0.5, 1.0, 1.9, 2.0, 2.1, 4.0, 10.0, 50.0, 99.0}) {
    const double ratio =
        std::tan(std::numbers::pi * corner * time_step) / std::tan(std::numbers::pi * frequency * time_step);
    EXPECT_NEAR(std::abs(response_at(impulse, frequency)), 1.0 / std::sqrt(1.0 + std::pow(ratio, 2 * order)), 1e-10)
        << frequency << " Hz";
  }
}

/// Each analogue pole pair turns the phase by atan2(damping x, 1 - x^2), x = corner/f warped, and a causal filter
/// leads: at the corner itself order * 45 degrees.
TEST_P(HighPassOfOrder, LeadsByFortyFiveDegreesPerOrderAtTheCorner) {
  const int order = GetParam();
  const std::complex<double> expected = std::polar(std::numbers::sqrt2 / 2, order * std::numbers::pi / 4);
  EXPECT_NEAR(std::abs(response_at(impulse_response(order), corner) - expected), 0.0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Orders, HighPassOfOrder, ::testing::Values(1, 2, 3, 4, 5, 8));

TEST(HighPass, IsCausalAndTheSameAtAllTimes) {
  const std::vector<double> early = impulse_response(5);
  const std::vector<double> late = impulse_response(5, 1000);
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(late[i], 0.0);
  for (std::size_t i = 1000; i < late.size(); ++i) ASSERT_EQ(late[i], early[i - 1000]);
}

TEST(HighPass, TakesAwayAConstant) {
  const GroundMotion answer = high_passed(GroundMotion{"offset", time_step, std::vector(20000, 3.0)}, corner * Hz, 5);
  EXPECT_NEAR(answer.samples()[0], 3.0, 0.4);
  EXPECT_NEAR(answer.samples().back(), 0.0, 1e-9);
  EXPECT_EQ(answer.notes().back(), "Causal Butterworth high-pass, order 5, corner 2 Hz.");
}

TEST(HighPass, RefusesWhatCannotBe) {
  const GroundMotion motion{"motion", time_step, {0.0, 1.0}};
  EXPECT_NE(message_of<InputError>([&] { (void)high_passed(motion, 100 * Hz, 5); }).find("> 0 Hz and < 100 Hz"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { (void)high_passed(motion, 0 * Hz, 5); }).find("corner = 0 Hz"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { (void)high_passed(motion, 1 * Hz, 0); }).find("order = 0"), std::string::npos);
}

/// Found for this record with the filter of another program (its PGA, and PGV over PGA).
TEST(HighPass, OfGebzeGivesTheKnownPeaks) {
  const char* folder = std::getenv("MOAT_RECORDS");
  if (!folder) GTEST_SKIP() << "set MOAT_RECORDS to a folder with PEER AT2 files to run this test";
  const std::filesystem::path file = std::filesystem::path{folder} / "RSN1161_KOCAELI_GBZ000.AT2";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "RSN1161_KOCAELI_GBZ000.AT2 is not in the folder of MOAT_RECORDS";
  const GroundMotion answer = high_passed(read_motion(file), 0.068 * Hz, 5);
  EXPECT_NEAR(answer.peak_acceleration() / g, 0.2392, 0.5e-4);
  EXPECT_NEAR((answer.peak_velocity() / answer.peak_acceleration()).si(), 0.2079, 1e-4);
}

}  // namespace
}  // namespace moat
