// Pairs of components at an angle of incidence.
#include "motions/plan_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

GroundMotion wave(const char* name, double step, double amplitude, double frequency, std::size_t count) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i) samples[i] = amplitude * std::sin(frequency * step * static_cast<double>(i));
  return {name, step, samples};
}

TEST(PlanMotion, ResolvesItsComponentsAtTheAngle) {
  const GroundMotion a = wave("a", 0.01, 2.0, 5.0, 300), b = wave("b", 0.01, 1.0, 8.0, 300);
  for (const double degrees : {0.0, 30.0, -75.0, 90.0, 180.0, 271.0}) {
    const GroundMotion motion = PlanMotion{a, b, degrees * deg};
    const double c = std::cos(degrees * deg), s = std::sin(degrees * deg);
    for (std::size_t i = 0; i < 300; ++i) {
      ASSERT_NEAR(motion.samples()[i], a.samples()[i] * c - b.samples()[i] * s, 1e-14);
      ASSERT_NEAR(motion.samples_y()[i], a.samples()[i] * s + b.samples()[i] * c, 1e-14);
    }
  }
  // Along an axis nothing is left across it.
  const GroundMotion along_y = PlanMotion{a, a.scaled_by(0.0), 90 * deg};
  for (const double sample : along_y.samples()) ASSERT_EQ(sample, 0.0);
  EXPECT_EQ(PlanMotion(a, b, 10 * deg).rotated(20 * deg).incidence, 30 * deg);
}

TEST(PlanMotion, CoarserComponentIsResampledExactly) {
  const GroundMotion fine = wave("fine", 0.005, 1.0, 3.0, 401), coarse = wave("coarse", 0.02, 1.0, 2.0, 81);
  for (const bool exchanged : {false, true}) {
    const GroundMotion motion = exchanged ? PlanMotion{coarse, fine} : PlanMotion{fine, coarse};
    EXPECT_EQ(motion.time_step(), 0.005);
    ASSERT_EQ(motion.samples().size(), 401U);
    for (double t = 0.0; t < 1.6; t += 0.0037) {
      const GroundVector at = motion.components_at(t);
      ASSERT_NEAR(exchanged ? at.x : at.y, coarse.acceleration_at(t), 1e-13);
      ASSERT_NEAR(exchanged ? at.y : at.x, fine.acceleration_at(t), 1e-13);
    }
    // The shorter one goes on with zeros.
    EXPECT_EQ(exchanged ? motion.components_at(1.9).x : motion.components_at(1.9).y, 0.0);
  }
}

TEST(PlanMotion, OneFactorScalesBoth) {
  const GroundMotion a = wave("a", 0.01, 4.0, 5.0, 300), b = wave("b", 0.01, 1.0, 8.0, 300);
  const double peak_a = a.peak_acceleration().si(), peak_b = b.peak_acceleration().si();
  const PlanMotion larger = PlanMotion{a, b}.scaled_to_larger_pga(2 * m / s / s);
  EXPECT_NEAR(larger.first.peak_acceleration().si(), 2.0, 1e-14);
  EXPECT_NEAR(larger.second.peak_acceleration().si(), 2.0 * peak_b / peak_a, 1e-14);
  EXPECT_NEAR((GroundMotion{PlanMotion{a, a}}.peak_acceleration().si()), std::sqrt(2.0) * peak_a, 1e-14);
}

TEST(PlanMotion, KnowsWhereItsComponentsComeFrom) {
  const GroundMotion a{"a", 0.01, {0.0, 1.0}, {}, {"/records/a", "aa"}},
      b{"b", 0.01, {0.0, 2.0}, {}, {"/records/b", "bb"}};
  EXPECT_EQ(a.scaled_by(3.0).components().size(), 1u);
  EXPECT_EQ(a.scaled_by(3.0).components()[0].scale_factor, 3.0);
  const auto components = PlanMotion{a.scaled_by(3.0), b}.resolved().scaled_by(0.5).components();
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].name, "a");
  EXPECT_EQ(components[0].file.sha256, "aa");
  EXPECT_EQ(components[0].scale_factor, 1.5);
  EXPECT_EQ(components[1].name, "b");
  EXPECT_EQ(components[1].file.path, "/records/b");
  EXPECT_EQ(components[1].scale_factor, 0.5);
}

TEST(PlanMotion, TakesAVerticalComponent) {
  // The vertical record is sampled finer, is shorter, and is not turned with the others.
  const GroundMotion a = wave("a", 0.02, 2.0, 5.0, 100), b = wave("b", 0.01, 1.0, 8.0, 150),
                     up{"up", 0.005, {0.5, 1.0, -2.0, 0.25}, {"header of up"}, {"/records/up", "uu"}};
  const PlanMotion pair{a, b, 90 * deg, up};
  const GroundMotion motion = pair;
  EXPECT_EQ(motion.name(), "a + b + up");
  EXPECT_EQ(motion.time_step(), 0.005);
  ASSERT_EQ(motion.samples_z().size(), motion.samples().size());
  EXPECT_EQ(motion.duration(), a.duration());
  for (double t = 0.0; t < 1.4; t += 0.0037) {
    const GroundVector at = motion.components_at(t);
    ASSERT_NEAR(at.x, -b.acceleration_at(t), 1e-13);
    ASSERT_NEAR(at.y, a.acceleration_at(t), 1e-13);
    if (t < 0.015 || t > 0.02) {
      ASSERT_NEAR(at.z, up.acceleration_at(t), 1e-13);
    }
  }
  const auto& notes = motion.notes();
  EXPECT_NE(std::find(notes.begin(), notes.end(), "header of up"), notes.end());
  EXPECT_NE(std::find(notes.begin(), notes.end(), "vertical component: " + up.description()), notes.end());
  EXPECT_EQ(PlanMotion(a, b, {}, up.scaled_by(1.0)).rotated(5 * deg).resolved().samples_z()[1], 1.0);
  // Without one everything is as before.
  EXPECT_TRUE(GroundMotion(PlanMotion{a, b}).samples_z().empty());
  // Finer horizontal components: the vertical one is resampled, and followed by zeros.
  const GroundMotion finer = PlanMotion{b, b, {}, GroundMotion{"up", 0.02, {0.0, 4.0}}};
  EXPECT_EQ(finer.samples_z()[1], 2.0);
  EXPECT_EQ(finer.samples_z()[2], 4.0);
  EXPECT_EQ(finer.samples_z()[3], 0.0);
}

TEST(PlanMotion, ScalesTheVerticalComponentWithTheOthersOrByItsOwnFactor) {
  const GroundMotion a = wave("a", 0.01, 4.0, 5.0, 300), up{"up", 0.01, {0.0, 2.0}, {}, {"/records/up", "uu"}};
  PlanMotion pair{a, a, {}, up};
  EXPECT_EQ(pair.scaled_by(1.5).resolved().samples_z()[1], 3.0);
  EXPECT_EQ(pair.scaled_by(1.5).resolved().scaled_by(2.0).samples_z()[1], 6.0);
  EXPECT_NEAR(pair.scaled_to_larger_pga(2.0 * a.peak_acceleration()).resolved().samples_z()[1], 4.0, 1e-14);
  pair.vertical_factor = 0.5;
  const GroundMotion scaled = pair.scaled_by(1.5).resolved();
  EXPECT_EQ(scaled.samples_z()[1], 1.0);
  EXPECT_EQ(scaled.samples()[40], 1.5 * a.samples()[40]);
  const auto components = scaled.scaled_by(2.0).components();
  ASSERT_EQ(components.size(), 3u);
  EXPECT_EQ(components[0].scale_factor, 3.0);
  EXPECT_EQ(components[1].scale_factor, 3.0);
  EXPECT_EQ(components[2].name, "up");
  EXPECT_EQ(components[2].file.sha256, "uu");
  EXPECT_EQ(components[2].scale_factor, 1.0);
  EXPECT_EQ(scaled.scale_factor(), 1.5);
}

TEST(WithVertical, AddsAComponentToAMotionOnALine) {
  const GroundMotion along{"along", 0.02, {0.0, 1.0, 3.0}, {"header"}, {"/records/a", "aa"}},
      up{"up", 0.01, {1.0, -1.0}, {"header of up"}, {"/records/up", "uu"}};
  const GroundMotion motion = with_vertical(along.scaled_by(2.0), up.scaled_by(3.0));
  EXPECT_EQ(motion.name(), "along + up");
  EXPECT_FALSE(motion.has_two_components());
  const std::vector<double> x{0.0, 1.0, 2.0, 4.0, 6.0}, z{3.0, -3.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(std::vector<double>(motion.samples().begin(), motion.samples().end()), x);
  EXPECT_EQ(std::vector<double>(motion.samples_z().begin(), motion.samples_z().end()), z);
  const auto components = motion.scaled_by(0.5).components();
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].file.path, "/records/a");
  EXPECT_EQ(components[0].scale_factor, 1.0);
  EXPECT_EQ(components[1].file.path, "/records/up");
  EXPECT_EQ(components[1].scale_factor, 1.5);
  EXPECT_EQ(motion.file().path, "/records/a");
  EXPECT_EQ(motion.scale_factor(), 2.0);
  const auto& notes = motion.notes();
  for (const char* note : {"header", "header of up"})
    EXPECT_NE(std::find(notes.begin(), notes.end(), note), notes.end());
}

TEST(PlanMotion, BadPairsAreRefused) {
  const GroundMotion a = wave("a", 0.01, 1.0, 5.0, 300), b = wave("b", 0.015, 1.0, 8.0, 300);
  EXPECT_EQ(message_of([&] {
              (void)PlanMotion{a, b}.resolved();
            }),
            "PlanMotion \"a + b\": the sampling intervals of its components, 0.01 s and 0.015 s, do not divide each "
            "other. Resample one of them, so that the longer interval is a multiple of the shorter.");
  EXPECT_EQ(message_of([&] {
              (void)PlanMotion{a, a, 360 * deg}.resolved();
            }),
            "PlanMotion \"a + a\": incidence = 360 deg is not allowed; it must be > -360 and < 360. Write it with its "
            "unit: 30 * deg.");
  EXPECT_EQ(
      message_of([&] {
        (void)PlanMotion{a, a, {}, b}.resolved();
      }),
      "PlanMotion \"a + a + b\": the sampling intervals of its components, 0.01 s, 0.01 s and 0.015 s, do not divide "
      "each other. Resample one of them, so that the longer interval is a multiple of the shorter.");
  EXPECT_EQ(message_of([&] { (void)with_vertical(a, b); }),
            "with_vertical \"a + b\": the sampling intervals of its components, 0.01 s and 0.015 s, do not divide each "
            "other. Resample one of them, so that the longer interval is a multiple of the shorter.");
  EXPECT_EQ(
      message_of([&] { (void)with_vertical(with_vertical(a, a), a); }),
      "with_vertical \"a + a + a\": \"a + a\" has several components already. Give motions of one component each.");
  EXPECT_EQ(
      message_of([&] {
        (void)PlanMotion{a, a, {}, {}, 2.0}.resolved();
      }),
      "PlanMotion \"a + a\": it has a vertical_factor without a vertical component. Give the record as `vertical`.");
  const GroundMotion both = PlanMotion{a, a};
  EXPECT_NE(message_of([&] {
              (void)PlanMotion{both, a}.resolved();
            }).find("\"a + a\" has several components already"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)response_spectrum(both, {1 * s}, 0.05); }).find("has two components"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
