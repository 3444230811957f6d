#include "motions/ground_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"

namespace moat {
namespace {

using namespace units;

/// The same function of time with `parts` intervals instead of each one.
GroundMotion refined(const GroundMotion& motion, int parts) {
  const std::span<const double> coarse = motion.samples();
  std::vector<double> fine{coarse[0]};
  for (std::size_t i = 1; i < coarse.size(); ++i)
    for (int k = 1; k <= parts; ++k) fine.push_back(coarse[i - 1] + (coarse[i] - coarse[i - 1]) * k / parts);
  return GroundMotion{motion.name(), motion.time_step() / parts, fine};
}

GroundMotion irregular_motion() {
  std::vector<double> samples;
  for (int i = 0; i < 200; ++i) samples.push_back(std::sin(1.7 * i) + 0.8 * std::cos(0.31 * i * i) - 0.1);
  return GroundMotion{"irregular", 0.02, samples};
}

TEST(GroundMotion, IsLinearBetweenSamplesAndZeroOutside) {
  const GroundMotion motion{"m", 0.5, {1.0, 3.0, -1.0}};
  EXPECT_DOUBLE_EQ(motion.duration(), 1.0);
  EXPECT_DOUBLE_EQ(motion.acceleration_at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(motion.acceleration_at(0.125), 1.5);
  EXPECT_DOUBLE_EQ(motion.acceleration_at(0.5), 3.0);
  EXPECT_DOUBLE_EQ(motion.acceleration_at(0.875), 0.0);
  EXPECT_DOUBLE_EQ(motion.acceleration_at(1.0), -1.0);
  EXPECT_EQ(motion.acceleration_at(std::nextafter(0.0, -1.0)), 0.0);
  EXPECT_EQ(motion.acceleration_at(std::nextafter(1.0, 2.0)), 0.0);
}

TEST(GroundMotion, GivesItsSamplesBackAtTheirTimes) {
  const GroundMotion motion = irregular_motion();
  for (std::size_t i = 0; i < motion.samples().size(); ++i)
    EXPECT_NEAR(motion.acceleration_at(static_cast<double>(i) * 0.02), motion.samples()[i], 1e-12) << i;
}

// a = 3 - 4 t: v = 3 t - 2 t^2 and d = 1.5 t^2 - 2/3 t^3.
TEST(GroundMotion, IntegratesExactly) {
  const GroundMotion motion{"m", 1.0, {3.0, -1.0, -5.0}};
  const std::vector<double> velocity = motion.velocity();
  const std::vector<double> displacement = motion.displacement();
  ASSERT_EQ(velocity.size(), 3u);
  ASSERT_EQ(displacement.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = static_cast<double>(i);
    EXPECT_NEAR(velocity[i], 3 * t - 2 * t * t, 1e-14);
    EXPECT_NEAR(displacement[i], 1.5 * t * t - 2.0 / 3.0 * t * t * t, 1e-14);
  }
}

TEST(GroundMotion, FindsPeaksBetweenSamples) {
  const GroundMotion motion{"m", 1.0, {3.0, -1.0, -5.0}};
  EXPECT_DOUBLE_EQ(motion.peak_acceleration().si(), 5.0);
  EXPECT_DOUBLE_EQ(motion.peak_velocity().si(), 2.0);        // at the last sample, where v = -2
  EXPECT_DOUBLE_EQ(motion.peak_displacement().si(), 1.125);  // at t = 1.5, where v = 0
  const GroundMotion shorter{"m", 1.0, {3.0, -1.0}};
  EXPECT_DOUBLE_EQ(shorter.peak_velocity().si(), 1.125);  // at t = 0.75, where a = 0
  const GroundMotion mirrored = motion.scaled_by(-1.0);
  EXPECT_DOUBLE_EQ(mirrored.peak_displacement().si(), 1.125);
}

TEST(GroundMotion, HasPeaksThatDoNotDependOnTheSamplingOfTheSameFunction) {
  const GroundMotion coarse = irregular_motion();
  const GroundMotion fine = refined(coarse, 16);
  EXPECT_NEAR(fine.peak_velocity() / coarse.peak_velocity(), 1.0, 1e-12);
  EXPECT_NEAR(fine.peak_displacement() / coarse.peak_displacement(), 1.0, 1e-12);
  EXPECT_NEAR(fine.displacement().back(), coarse.displacement().back(), 1e-12);
}

TEST(GroundMotion, PeakDisplacementUnderConstantAccelerationThatTurns) {
  // Two steps of +1, one step down to -1, then -1: v grows to 2, and the peak lies where it has come back to 0.
  const GroundMotion motion{"m", 1.0, {1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0}};
  // v(3) = 2, then v = 2 - (t - 3): zero at t = 5, at a sample; d(2) = 2, d(3) = 2 + 2 + 1/2 - 1/3, d(5) = d(3) + 2.
  EXPECT_NEAR(motion.peak_displacement().si(), 2.0 + 2.0 + 0.5 - 1.0 / 3.0 + 2.0, 1e-13);
}

TEST(GroundMotion, ScalesEverythingByOneFactor) {
  const GroundMotion motion{"m", 0.5, {0.0, 2.0, -4.0}, {"line"}};
  const GroundMotion scaled = motion.scaled_to_pga(0.4 * g);
  EXPECT_DOUBLE_EQ(scaled.peak_acceleration().si(), 0.4 * standard_gravity);
  EXPECT_DOUBLE_EQ(scaled.samples()[1], -0.2 * standard_gravity * -1.0);
  EXPECT_EQ(scaled.name(), "m");
  EXPECT_EQ(scaled.time_step(), 0.5);
  EXPECT_EQ(scaled.notes(), (std::vector<std::string>{"line", "accelerations multiplied by 0.980665"}));
  EXPECT_DOUBLE_EQ(motion.samples()[2], -4.0) << "the original is left alone";
  const GroundMotion turned = motion.scaled_by(-0.5);
  EXPECT_DOUBLE_EQ(turned.samples()[1], -1.0);
  EXPECT_DOUBLE_EQ(turned.samples()[2], 2.0);
}

TEST(GroundMotion, RefusesToScaleWhatCannotBeScaled) {
  const GroundMotion motion{"m", 0.5, {0.0, 2.0}};
  const GroundMotion still{"still", 0.5, {0.0, 0.0}};
  EXPECT_EQ(message_of<InputError>([&] { (void)still.scaled_to_pga(0.4 * g); }),
            "GroundMotion \"still\": a motion that is zero everywhere cannot be scaled to a peak acceleration. "
            "Check the file or the parameters it was made from.");
  EXPECT_EQ(message_of<InputError>([&] { (void)motion.scaled_to_pga(0 * g); }),
            "GroundMotion \"m\": target PGA = 0 m/s^2 is not allowed; it must be > 0 m/s^2 and finite. "
            "Give it as, for example, 0.4 * g.");
  EXPECT_THROW((void)motion.scaled_to_pga(-1 * g), InputError);
  EXPECT_EQ(message_of<InputError>([&] { (void)motion.scaled_by(std::numeric_limits<double>::infinity()); }),
            "GroundMotion \"m\": scale factor = inf is not allowed; it must be a finite number. Look for a division by "
            "zero in the calculation that gave it.");
}

TEST(GroundMotion, RefusesSamplesThatAreNoMotion) {
  EXPECT_EQ(message_of<InputError>([] {
              GroundMotion("m", 0.0, {0.0, 1.0});
            }),
            "GroundMotion \"m\": time step = 0 s is not allowed; it must be from 1e-09 s to 1e+06 s. "
            "Give the interval between two samples.");
  EXPECT_EQ(message_of<InputError>([] { GroundMotion("m", 0.01, {1.0}); }),
            "GroundMotion \"m\": number of samples = 1 is not allowed; it must be >= 2. "
            "Give the acceleration at the beginning and at the end of at least one time step.");
  EXPECT_THROW(GroundMotion("m", 0.01, {}), InputError);
  EXPECT_EQ(message_of<InputError>([] {
              GroundMotion("m", 0.01, {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()});
            }),
            "GroundMotion \"m\": sample 2 (counted from 0) = nan m/s^2 is not allowed; it must be a finite number. "
            "Repair the record before using it.");
}

TEST(GroundMotion, KnowsItsFileAndScaleFactorThroughEveryChange) {
  const GroundMotion read{"record", 0.01, {0.0, 1.0, -2.0}, {"header"}, {"/records/a.AT2", "abc"}};
  EXPECT_EQ(read.scale_factor(), 1.0);
  const GroundMotion changed = read.scaled_by(3.0).with_samples({0.0, 1.0}, "filtered").scaled_by(0.5);
  EXPECT_EQ(changed.file().path, "/records/a.AT2");
  EXPECT_EQ(changed.file().sha256, "abc");
  EXPECT_EQ(changed.scale_factor(), 1.5);
  EXPECT_EQ(changed.notes(), (std::vector<std::string>{"header", "accelerations multiplied by 3", "filtered",
                                                       "accelerations multiplied by 0.5"}));
}

TEST(GroundMotion, RefusesNumbersBeyondAllGrounds) {
  for (const double time_step : {1e-300, 1e-10, 1e7, 1e300})
    EXPECT_THROW((GroundMotion{"record", time_step, {0.0, 1.0}}), InputError) << time_step;
  EXPECT_NE(message_of<InputError>([] {
              GroundMotion("record", 0.01, {0.0, 1e300});
            }).find("sample 1 (counted from 0) = 1e+300 m/s^2 is not allowed"),
            std::string::npos);
}

TEST(GroundMotion, DescribesItselfInOneLine) {
  // One triangle of 1 g: the velocity is its area, 0.05 s * 9.80665 m/s^2.
  const GroundMotion motion{"triangle", 0.05, {0.0, standard_gravity, 0.0}};
  EXPECT_EQ(motion.description(),
            "triangle: PGA 1.0000 g, PGV 49.03 cm/s, PGV/PGA 0.0500 s, time step 0.05 s, duration 0.1 s, 3 samples");
  const GroundMotion still{"still", 0.5, {0.0, 0.0}};
  EXPECT_EQ(still.description(),
            "still: PGA 0.0000 g, PGV 0.00 cm/s, PGV/PGA undefined, time step 0.5 s, duration 0.5 s, 2 samples");
}

}  // namespace
}  // namespace moat
