#include "motions/motion_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/near_fault_pulse.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;

GroundMotion constant(double acceleration, double duration) {
  return GroundMotion{"constant", duration / 100.0, std::vector<double>(101, acceleration)};
}

TEST(MotionMeasures, AriasIntensityOfAConstantAcceleration) {
  // pi/(2 g) a^2 t
  EXPECT_NEAR(arias_intensity(constant(2.0, 5.0)).si(), pi / (2.0 * 9.80665) * 4.0 * 5.0, 1e-12);
}

TEST(MotionMeasures, AriasIntensityIsExactBetweenSamples) {
  // From 0 to 3 and back to 0, 1 s each: the integral of the square is 2 * 9/3.
  const GroundMotion triangle{"triangle", 1.0, {0.0, 3.0, 0.0}};
  EXPECT_NEAR(arias_intensity(triangle).si(), pi / (2.0 * 9.80665) * 6.0, 1e-12);
  // Through zero: the same as two triangles of half a second.
  const GroundMotion through_zero{"through zero", 1.0, {3.0, -3.0}};
  EXPECT_NEAR(arias_intensity(through_zero).si(), pi / (2.0 * 9.80665) * 3.0, 1e-12);
}

TEST(MotionMeasures, SignificantDurationOfAConstantAcceleration) {
  const MotionInterval interval = significant_duration(constant(-1.5, 20.0));
  EXPECT_NEAR(interval.start, 1.0, 1e-9);
  EXPECT_NEAR(interval.end, 19.0, 1e-9);
  EXPECT_NEAR(interval.length(), 18.0, 1e-9);
}

TEST(MotionMeasures, SignificantDurationInsideAnInterval) {
  // a = t over 1 s: t^3/3 reaches the share s of its end value at s^(1/3).
  const GroundMotion ramp{"ramp", 1.0, {0.0, 1.0}};
  const MotionInterval interval = significant_duration(ramp, 0.05, 0.75);
  EXPECT_NEAR(interval.start, std::cbrt(0.05), 1e-12);
  EXPECT_NEAR(interval.end, std::cbrt(0.75), 1e-12);
  const MotionInterval whole = significant_duration(ramp, 0.0, 1.0);
  EXPECT_EQ(whole.start, 0.0);
  EXPECT_NEAR(whole.end, 1.0, 1e-12);
}

TEST(MotionMeasures, DoNotChangeWithTheSignAndGrowWithTheSquare) {
  const GroundMotion pulse = near_fault_pulse(), twice = pulse.scaled_by(-2.0);
  EXPECT_NEAR(arias_intensity(twice).si(), 4.0 * arias_intensity(pulse).si(), 1e-12);
  EXPECT_NEAR(significant_duration(twice).length(), significant_duration(pulse).length(), 1e-12);
  EXPECT_EQ(pulse_period(twice).si(), pulse_period(pulse).si());
}

TEST(MotionMeasures, PulsePeriodScalesWithTheMotion) {
  // The same samples at twice the interval: an oscillator of twice the period has the same response.
  const GroundMotion pulse = near_fault_pulse({.pulse_period = 1 * s});
  const GroundMotion slow{"slow", 2.0 * pulse.time_step(), {pulse.samples().begin(), pulse.samples().end()}};
  const double spacing = std::pow(200.0, 1.0 / 399.0);
  EXPECT_NEAR(std::log(pulse_period(slow).si() / pulse_period(pulse).si()), std::log(2.0), std::log(spacing));
}

TEST(MotionMeasures, PulsePeriodOfALongHarmonicMotionIsItsPeriod) {
  // Resonance after 30 cycles with 5 % damping; the pseudo-velocity of the steady state is largest at
  // T sqrt(1 - 2 z^2) for PSV = w u, which differs from T by 0.25 %.
  std::vector<double> samples;
  for (int i = 0; i <= 6000; ++i) samples.push_back(std::sin(2.0 * pi * i * 0.01 / 2.0));
  const double spacing = std::pow(200.0, 1.0 / 399.0);
  EXPECT_NEAR(pulse_period(GroundMotion{"harmonic", 0.01, samples}).si() / 2.0, 1.0, spacing - 1.0 + 0.005);
}

TEST(MotionMeasures, SpacedPeriodsHaveAConstantRatio) {
  const std::vector<Time> periods = spaced_periods(0.1 * s, 10 * s, 5);
  ASSERT_EQ(periods.size(), 5u);
  EXPECT_EQ(periods.front().si(), 0.1);
  EXPECT_NEAR(periods[2].si(), 1.0, 1e-12);
  EXPECT_EQ(periods.back().si(), 10.0);
}

TEST(MotionMeasures, PseudoVelocityIsPseudoAccelerationOverFrequency) {
  const ResponseSpectrum spectrum = response_spectrum(near_fault_pulse(), {1 * s, 2 * s}, 0.05);
  const std::vector<double> velocities = pseudo_velocity(spectrum);
  EXPECT_NEAR(velocities[1], 2.0 * pi / 2.0 * spectrum.displacement[1], 1e-12);
}

TEST(MotionMeasures, RefuseWrongInput) {
  const GroundMotion zero{"zero", 0.01, {0.0, 0.0, 0.0}};
  EXPECT_EQ(message_of<InputError>([&] { (void)significant_duration(zero); }),
            "significant_duration \"zero\": the motion is zero everywhere and has no duration. Check the file.");
  EXPECT_EQ(message_of<InputError>([&] { (void)significant_duration(constant(1.0, 1.0), 0.5, 0.5); }),
            "significant_duration \"constant\": to = 0.5 is not allowed; it must be > from and <= 1. Give 95 % as "
            "0.95.");
  EXPECT_NE(message_of<InputError>([&] { (void)significant_duration(constant(1.0, 1.0), -0.1); }).find("from = -0.1"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { (void)spaced_periods(1 * s, 1 * s, 5); }).find("last = 1 s"),
            std::string::npos);
  const GroundMotion two = zero.with_component_y({0.0, 1.0, 0.0}, zero, zero);
  EXPECT_NE(message_of<InputError>([&] { (void)arias_intensity(two); }).find("two components"), std::string::npos);
}

}  // namespace
}  // namespace moat
