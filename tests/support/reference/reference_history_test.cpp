// The independent reference against closed forms.

#include "reference_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference_peak.hpp"

namespace moat::testing {
namespace {

struct Oscillator {
  double mass = 1e5;       ///< kg
  double frequency = 0.0;  ///< 1/s; 0: no spring
  double displacement = 0.0, velocity = 0.0;
};

/// A ground that does not move, with samples so far apart that they do not shorten a step.
PlainMotion still() { return {2.0, {0.0, 0.0}}; }

/// The node "mass" on the spring "spring" for two seconds on still ground.
PlainModel oscillator(const Oscillator& of) {
  PlainModel model;
  model.nodes = {{"mass", of.mass, of.displacement, of.velocity}};
  if (of.frequency > 0.0)
    model.springs = {
        {"spring", PlainSpring::Kind::storey, plain_ground, 0, of.mass * of.frequency * of.frequency, 0.0}};
  model.motion = still();
  model.end = 2.0;
  return model;
}

/// The free "mass" flies to the right into the gap "wall" of 10 cm before the ground.
PlainModel flight(double mass, double speed, const PlainLaw& law) {
  PlainModel model = oscillator({.mass = mass, .velocity = speed});
  model.gaps = {{"wall", "wall", {0, plain_ground, 0.0}, {}, 0.1, law}};
  return model;
}

using std::numbers::pi;

// The default tolerance of one step is 1e-10, and the cases below take some hundred steps.
constexpr double round_off = 1e-8;

TEST(ReferenceHistory, ErrorFallsWithTheFifthPowerOfTheStep) {
  const double w = 7.0, start = 0.02;
  const PlainModel model = oscillator({.frequency = w, .displacement = start});
  const auto error = [&](double phase) {
    const ReferenceResult result = reference_history(model, {.largest_phase = phase, .tolerance = 1.0});
    return std::hypot(result.displacement[0] - start * std::cos(w * model.end),
                      result.velocity[0] / w + start * std::sin(w * model.end));
  };
  EXPECT_NEAR(std::log2(error(0.4) / error(0.2)), 5.0, 0.5);
}

TEST(ReferenceHistory, AFreeImpactDeliversTheRestitutionOfItsLaw) {
  const double mass = 4e5, speed = 0.6, ratio = 0.3, angle = std::acos(ratio);
  const auto rebound = [&](const PlainLaw& law) {
    return -reference_history(flight(mass, speed, law)).velocity[0] / speed;
  };
  using K = PlainLawKind;
  using D = PlainDamping;
  EXPECT_NEAR(rebound({K::linear_elastic, 3e8}), 1.0, round_off);
  EXPECT_NEAR(rebound({K::hertz, 2e9}), 1.0, round_off);
  for (const double e : {0.2, 0.65, 0.95}) {
    EXPECT_NEAR(rebound({K::exact_hertz_damp, 2e9, e}), e, round_off);
    EXPECT_NEAR(rebound({K::exact_kelvin, 3e8, e}), e, round_off);
    EXPECT_NEAR(rebound({K::exact_kelvin, 3e8, e, 0.0, D::may_pull}), e, round_off);
    EXPECT_NEAR(rebound({K::kelvin, 3e8, e, 0.0, D::may_pull}), e, round_off);
  }
  EXPECT_NEAR(rebound({K::kelvin_by_damping_ratio, 3e8, 1.0, ratio}), std::exp(-2.0 * angle / std::tan(angle)),
              round_off);
  // Damped in approach only: exp(-a cot a), with the angle of 2 xi/sqrt(5) for the root law.
  const double e = 0.65;
  const double linear = std::acos((1.0 - e * e) / (e * (e * (pi - 2.0) + 2.0)));
  EXPECT_NEAR(rebound({K::modified_linear_viscoelastic, 3e8, e}), std::exp(-linear / std::tan(linear)), round_off);
  const double printed = std::acos((1.0 - e * e) / (5.0 * e * e));
  EXPECT_NEAR(rebound({K::modified_hertz_damp_printed, 2e9, e, 0.0, D::approach_only}),
              std::exp(-printed / std::tan(printed)), round_off);
  EXPECT_NEAR(rebound({K::modified_hertz_damp_printed, 2e9, e, 0.0, D::throughout}),
              std::exp(-2.0 * printed / std::tan(printed)), round_off);
  EXPECT_NEAR(rebound({K::modified_hertz_damp_printed, 2e9, e, 0.0, D::may_pull}),
              std::exp(-pi * std::cos(printed) / std::sin(printed)), round_off);
  // Hertz, z = 3/4 (1 - e^2): the restitution e' with ln((1 + z)/(1 - z e')) = z (1 + e').
  const double z = 0.75 * (1.0 - e * e), delivered = rebound({K::hertz_damp, 2e9, e});
  EXPECT_NEAR(std::log((1.0 + z) / (1.0 - z * delivered)), z * (1.0 + delivered), round_off);
}

// The acceleration of a body that touches while another contact presses it has a nearly infinite rate at the touch.
TEST(ReferencePeak, IsThatOfACurveAndNotOfACubicThatLeavesIt) {
  EXPECT_NEAR((HermiteCubic{1.0, 0.0, 1.0, 0.0, -1.0}.turned()), 0.25, 1e-15);
  EXPECT_NEAR((HermiteCubic{1.0, 0.0, -1.0, 0.0, 1.0}.turned()), -0.25, 1e-15);
  EXPECT_NEAR((HermiteCubic{1.0, 1.0, 1e6, 1.3, -0.2}.turned()), 1.5, 1e-5);
  EXPECT_NEAR((HermiteCubic{1.0, -1.0, -1e6, -1.3, 0.2}.turned()), -1.5, 1e-5);
}

TEST(ReferenceHistory, TheCheckNamesTheChangeOfEveryPeak) {
  const PlainModel model = flight(4e5, 0.6, {PlainLawKind::hertz_damp, 2e9, 0.65});
  const CheckedReference checked = checked_reference(model);
  EXPECT_EQ(checked.peak_changes.size(), checked.result.peaks.size());
  EXPECT_TRUE(checked.settled(1e-6));
  const CheckedReference coarse = checked_reference(model, {.largest_phase = 2.0, .tolerance = 1e-2});
  EXPECT_FALSE(coarse.settled(1e-6));
  EXPECT_GT(coarse.largest_change, checked.largest_change);
}

}  // namespace
}  // namespace moat::testing
