// The independent reference against closed forms.

#include "reference_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference_peak.hpp"

namespace moat::testing {
namespace {

struct Oscillator {
  double mass = 1e5;           ///< kg
  double frequency = 0.0;      ///< 1/s; 0: no spring
  double damping_ratio = 0.0;  ///< of critical
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
  if (of.damping_ratio > 0.0)
    model.dashpots = {{"dashpot", plain_ground, 0, 2.0 * of.damping_ratio * of.mass * of.frequency}};
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

ReferencePeak peak_of(const ReferenceResult& result, const std::string& quantity, const std::string& where) {
  for (const ReferencePeak& peak : result.peaks)
    if (peak.quantity == quantity && peak.where == where) return peak;
  throw std::invalid_argument{"no peak of " + quantity + " at " + where};
}

using std::numbers::pi;

// The default tolerance of one step is 1e-10, and the cases below take some hundred steps.
constexpr double round_off = 1e-8;

TEST(ReferenceHistory, FreeVibrationDecaysAsItShould) {
  const double w = 7.0, damping_ratio = 0.05, start = 0.02;
  const PlainModel model = oscillator({.frequency = w, .damping_ratio = damping_ratio, .displacement = start});
  const ReferenceResult result = reference_history(model);
  const double t = model.end, damped = w * std::sqrt(1.0 - damping_ratio * damping_ratio);
  const double decay = std::exp(-damping_ratio * w * t);
  const double sine = std::sin(damped * t), cosine = std::cos(damped * t);
  EXPECT_NEAR(result.displacement[0], start * decay * (cosine + damping_ratio * w / damped * sine), round_off * start);
  EXPECT_NEAR(result.velocity[0], -start * decay * w * w / damped * sine, round_off * w * start);
  // The largest speed is the first, where tan(damped t) = damped/(damping_ratio w).
  const double at = std::atan2(damped, damping_ratio * w) / damped;
  const double fastest = start * std::exp(-damping_ratio * w * at) * w * w / damped * std::sin(damped * at);
  EXPECT_NEAR(peak_of(result, "velocity", "mass").value / fastest, 1.0, round_off);
  EXPECT_NEAR(peak_of(result, "velocity", "mass").time, at, 1e-5);
  EXPECT_NEAR(peak_of(result, "drift", "spring").value, start, round_off * start);
}

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

TEST(ReferenceHistory, ABearingYieldsAndUnloadsWhereItsEnergySays) {
  // A mass is pushed through yield, comes to rest, slides a little on the way back, and swings elastically then.
  const double mass = 1e5, speed = 1.5, yield_force = 1e6, limit = 0.01, k2 = 2e6;
  PlainModel model = oscillator({.mass = mass, .velocity = speed});
  model.bearings = {{"bearing", plain_ground, 0, yield_force, limit, k2}};
  const ReferenceResult result = reference_history(model);

  // m v^2/2 = F_y d_y/2 + F_y (D - d_y) + k2 (D - d_y)^2/2.
  const double excess = 0.5 * mass * speed * speed - 0.5 * yield_force * limit;
  const double beyond = (std::sqrt(yield_force * yield_force + 2.0 * k2 * excess) - yield_force) / k2;
  EXPECT_NEAR(peak_of(result, "isolator_deformation", "bearing").value / (limit + beyond), 1.0, round_off);
  EXPECT_NEAR(peak_of(result, "isolator_force", "bearing").value / (yield_force + k2 * beyond), 1.0, round_off);

  // The slider has the force S and, after 2 d_y of turning round, dissipates S (swing - 2 d_y) up to the next rest at
  // D - swing: k2 (D^2 - (D - swing)^2)/2 = S (swing - 2 d_y).
  const double k1 = yield_force / limit, slider = (k1 - k2) * limit, farthest = limit + beyond;
  const double b = k2 * farthest - slider;
  const double swing = (b + std::sqrt(b * b + 4.0 * k2 * slider * limit)) / k2;
  ASSERT_GT(swing, 2.0 * limit);
  // The energy of the elastic swing that follows, about the slip D - swing + d_y.
  const double rest = farthest - swing, slip = rest + limit;
  ASSERT_LT((k1 - k2) * slip / k1 - rest, limit);
  const double u = result.displacement[0], v = result.velocity[0];
  const double energy = 0.5 * (mass * v * v + k2 * u * u + (k1 - k2) * (u - slip) * (u - slip));
  EXPECT_NEAR(energy / (0.5 * (k2 * rest * rest + (k1 - k2) * limit * limit)), 1.0, round_off);
}

TEST(ReferenceHistory, ElasticImpactsReachTheirClosedForms) {
  const double mass = 4e5, speed = 0.6;
  const double linear = 3e8, hertz = 2e9;
  const ReferenceResult spring = reference_history(flight(mass, speed, {PlainLawKind::linear_elastic, linear}));
  ASSERT_EQ(spring.touches.size(), 1U);
  EXPECT_NEAR(spring.touches[0].time, 0.1 / speed, 1e-12);
  EXPECT_NEAR(spring.touches[0].approach_speed, speed, 1e-12);
  EXPECT_NEAR(spring.velocity[0], -speed, round_off);
  EXPECT_NEAR(peak_of(spring, "indentation", "wall").value / (speed * std::sqrt(mass / linear)), 1.0, round_off);
  EXPECT_NEAR(peak_of(spring, "impact_force", "wall").value / (speed * std::sqrt(mass * linear)), 1.0, round_off);

  const ReferenceResult sphere = reference_history(flight(mass, speed, {PlainLawKind::hertz, hertz}));
  const double deepest = std::pow(1.25 * mass * speed * speed / hertz, 0.4);
  EXPECT_NEAR(sphere.velocity[0], -speed, round_off);
  EXPECT_NEAR(peak_of(sphere, "indentation", "wall").value / deepest, 1.0, round_off);
  EXPECT_NEAR(peak_of(sphere, "impact_force", "wall").value / (hertz * std::pow(deepest, 1.5)), 1.0, round_off);
  EXPECT_NEAR(peak_of(sphere, "absolute_acceleration", "mass").value / (hertz / mass * std::pow(deepest, 1.5)), 1.0,
              round_off);
}

TEST(ReferenceHistory, AFreeImpactDeliversTheRestitutionOfItsLaw) {
  const double mass = 4e5, speed = 0.6, ratio = 0.3, angle = std::acos(ratio);
  const auto rebound = [&](const PlainLaw& law) {
    return -reference_history(flight(mass, speed, law)).velocity[0] / speed;
  };
  using K = PlainLawKind;
  using D = PlainDamping;
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

TEST(ReferenceHistory, AnImpactBetweenTwoNodesKeepsTheirMomentum) {
  // A free body hits a column between two floors that nothing else joins: their effective mass counts.
  PlainModel model = flight(2e5, 0.8, {PlainLawKind::exact_kelvin, 3e8, 0.5});
  model.nodes.push_back({"lower", 3e5, 0.0, 0.0});
  model.nodes.push_back({"upper", 1e5, 0.0, 0.0});
  const double share = 0.3;
  model.gaps[0].right = {1, 2, share};
  model.end = model.motion.time_step = 0.3;
  const ReferenceResult result = reference_history(model);
  const double impulse = 2e5 * (0.8 - result.velocity[0]);
  EXPECT_NEAR(result.velocity[1], impulse * (1.0 - share) / 3e5, round_off);
  EXPECT_NEAR(result.velocity[2], impulse * share / 1e5, round_off);
  const double point = (1.0 - share) * result.velocity[1] + share * result.velocity[2];
  EXPECT_NEAR(point - result.velocity[0], 0.5 * 0.8, round_off);
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
