#include "motions/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/near_fault_pulse.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;

ResponseSpectrum single(const GroundMotion& motion, double period, double damping_ratio) {
  const std::vector<Time> periods{period * s};
  return response_spectrum(motion, periods, damping_ratio);
}

// Under a constant acceleration a from rest, u swings about a/w^2 and overshoots it by exp(-k pi), with
// k = ratio / sqrt(1 - ratio^2); the absolute acceleration overshoots a by exp(-k (pi - 2 atan k)).
TEST(ResponseSpectrum, IsExactForAStep) {
  const double a = 2.0;
  const GroundMotion step{"step", 0.01, std::vector<double>(2001, a)};
  for (const double period : {0.003, 0.01, 0.1, 0.37, 1.0, 2.5}) {
    for (const double ratio : {0.0, 0.05, 0.2, 0.7}) {
      const double w = 2.0 * pi / period;
      const double k = ratio / std::sqrt(1.0 - ratio * ratio);
      const ResponseSpectrum spectrum = single(step, period, ratio);
      EXPECT_NEAR(spectrum.displacement[0] * w * w / (a * (1.0 + std::exp(-k * pi))), 1.0, 3e-6) << period << ratio;
      EXPECT_NEAR(spectrum.absolute_acceleration[0] / (a * (1.0 + std::exp(-k * (pi - 2.0 * std::atan(k))))), 1.0, 3e-6)
          << period << ' ' << ratio;
      EXPECT_DOUBLE_EQ(spectrum.pseudo_acceleration[0], w * w * spectrum.displacement[0]);
    }
  }
}

TEST(ResponseSpectrum, TakesAListOfPeriods) {
  const GroundMotion step{"step", 0.01, std::vector<double>(201, 2.0)};
  const ResponseSpectrum spectrum = response_spectrum(step, {0.1 * s, 1 * s}, 0.05);
  EXPECT_EQ(spectrum.period, (std::vector<double>{0.1, 1.0}));
  EXPECT_EQ(spectrum.displacement[1], single(step, 1.0, 0.05).displacement[0]);
}

// Under a ramp r t, undamped: u = -r/w^2 (t - sin(w t)/w). Its energy at the end stays in a free vibration.
TEST(ResponseSpectrum, CountsTheFreeVibrationAfterARamp) {
  const double rate = 3.0;
  const double end = 0.4;
  const GroundMotion ramp{"ramp", end, {0.0, rate * end}};
  for (const double period : {0.3, 1.0, 5.0, 50.0}) {
    const double w = 2.0 * pi / period;
    const double displacement = rate / (w * w) * (end - std::sin(w * end) / w);
    const double velocity = rate / (w * w) * (1.0 - std::cos(w * end));
    const double expected = std::hypot(displacement, velocity / w);
    EXPECT_NEAR(single(ramp, period, 0.0).displacement[0] / expected, 1.0, 3e-6) << period;
  }
}

// A short impulse I on a long-period oscillator: u = I/w exp(-ratio w t) sin(wd t)/sqrt(1 - ratio^2).
TEST(ResponseSpectrum, ApproachesTheImpulseResponseForAShortTriangle) {
  const double width = 1e-3;
  const GroundMotion triangle{"triangle", width / 2, {0.0, 1.0, 0.0}};
  const double impulse = width / 2;
  const double period = 5.0;
  const double ratio = 0.1;
  const double w = 2.0 * pi / period;
  const double damped = w * std::sqrt(1.0 - ratio * ratio);
  const double time = std::atan(damped / (ratio * w)) / damped;
  const double expected = impulse / damped * std::exp(-ratio * w * time) * std::sin(damped * time);
  // Swinging starts in the middle of the triangle; the error is of second order in width / period.
  EXPECT_NEAR(single(triangle, period, ratio).displacement[0] / expected, 1.0, 1e-6);
}

// n undamped cycles in resonance reach u = a n pi / w^2.
TEST(ResponseSpectrum, ConvergesWithSecondOrderForASampledHarmonicInResonance) {
  const int cycles = 5;
  const double period = 0.8;
  const double w = 2.0 * pi / period;
  const auto error = [&](int samples_per_cycle) {
    std::vector<double> samples;
    for (int i = 0; i <= cycles * samples_per_cycle; ++i) samples.push_back(std::sin(2.0 * pi * i / samples_per_cycle));
    const GroundMotion motion{"harmonic", period / samples_per_cycle, samples};
    return std::abs(single(motion, period, 0.0).displacement[0] * w * w / (cycles * pi) - 1.0);
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 2.0, 0.05);
  EXPECT_LT(error(40), 0.005);
}

TEST(ResponseSpectrum, DoesNotDependOnTheSamplingOfTheSameFunction) {
  std::vector<double> coarse_samples;
  for (int i = 0; i < 300; ++i) coarse_samples.push_back(std::sin(1.7 * i) + 0.8 * std::cos(0.31 * i * i));
  std::vector<double> fine_samples{coarse_samples[0]};
  for (std::size_t i = 1; i < coarse_samples.size(); ++i)
    for (int k = 1; k <= 10; ++k)
      fine_samples.push_back(coarse_samples[i - 1] + (coarse_samples[i] - coarse_samples[i - 1]) * k / 10.0);
  const GroundMotion coarse{"coarse", 0.02, coarse_samples};
  const GroundMotion fine{"fine", 0.002, fine_samples};
  for (const double period : {0.05, 0.3, 1.5, 4.0}) {
    EXPECT_NEAR(single(fine, period, 0.05).displacement[0] / single(coarse, period, 0.05).displacement[0], 1.0, 3e-5);
    EXPECT_NEAR(
        single(fine, period, 0.05).absolute_acceleration[0] / single(coarse, period, 0.05).absolute_acceleration[0],
        1.0, 3e-5);
  }
}

TEST(ResponseSpectrum, BeginsAtThePeakGroundAccelerationAndEndsAtThePeakGroundDisplacement) {
  const GroundMotion motion = near_fault_pulse();
  const std::vector<Time> periods{0 * s, 0.005 * s, 900 * s};
  const ResponseSpectrum spectrum = response_spectrum(motion, periods, 0.05);
  const double pga = motion.peak_acceleration().si();
  EXPECT_EQ(spectrum.damping_ratio, 0.05);
  EXPECT_EQ(spectrum.period, (std::vector<double>{0.0, 0.005, 900.0}));
  EXPECT_DOUBLE_EQ(spectrum.absolute_acceleration[0], pga);
  EXPECT_DOUBLE_EQ(spectrum.pseudo_acceleration[0], pga);
  EXPECT_EQ(spectrum.displacement[0], 0.0);
  EXPECT_NEAR(spectrum.absolute_acceleration[1] / pga, 1.0, 1e-3);
  EXPECT_NEAR(spectrum.displacement[2] / motion.peak_displacement().si(), 1.0, 1e-2);
}

TEST(ResponseSpectrum, NamesTheParameterOutOfRange) {
  const GroundMotion motion{"m", 0.01, {0.0, 1.0}};
  EXPECT_EQ(message_of<InputError>([&] { (void)single(motion, 1.0, 5.0); }),
            "response_spectrum \"m\": damping_ratio = 5 is not allowed; it must be >= 0 and < 1. Give 5 % as 0.05.");
  EXPECT_EQ(message_of<InputError>([&] { (void)single(motion, 1e-5, 0.05); }),
            "response_spectrum \"m\": period = 1e-05 s is not allowed; it must be 0 s, or from 0.0001 s to 1000 s. "
            "Give 0 s for a rigid oscillator.");
  EXPECT_THROW((void)single(motion, -1.0, 0.05), InputError);
}

}  // namespace
}  // namespace moat
