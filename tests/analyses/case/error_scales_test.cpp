// An impact of one body does not change the accuracy of another body, nor of the motion after the impact.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "analysis_testing.hpp"
#include "random_draws.hpp"
#include "random_motion.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

using Peaks = std::map<std::string, double>;

constexpr double interval = 0.02;  // s, of the motions: accuracy is up to the step control

struct Case {
  ShearBuilding building;
  GroundMotion motion;
};

Case drawn(std::uint64_t seed) {
  RandomDraws draws{seed};
  const int storeys = draws.integer(1, 5);
  const double mass = 1e3 * draws.decades(50.0, 500.0), period = storeys * draws.uniform(0.08, 0.15);
  const double angle = std::numbers::pi / (2.0 * (2.0 * storeys + 1.0));
  const double root = std::numbers::pi / period / std::sin(angle);  // sqrt(k/m) of a uniform shear building
  ShearBuilding building{.storeys = storeys,
                         .floor_mass = mass * kg,
                         .storey_stiffness = mass * root * root * N / m,
                         .damping = RayleighDamping{.ratio = draws.decades(0.005, 0.05)}};
  return {building, GroundMotion{"drawn", interval, random_motion(draws).samples}};
}

// An oscillator of this mass that pounds walls on both sides; stiff walls, so that a lighter one has larger
// accelerations. A gap that never closes joins it to the top of the building: bodies that nothing joins have runs of
// their own.
void add_body(Model& model, double mass, NodeId top) {
  const NodeId body = add(model, Oscillator{.mass = mass, .frequency = 2.0 * std::numbers::pi / 0.5});
  add(model,
      Moat{
          .name = "body moat", .around = body, .clearance = 5 * mm, .law = LinearElastic{.stiffness = 6.25e8 * N / m}});
  add(model, Gap{.name = "far apart",
                 .left = top,
                 .right = body,
                 .clearance = 1 * km,
                 .law = LinearElastic{.stiffness = 1e8 * N / m}});
}

// Of the building alone.
Peaks peaks(const Case& drawn, double body_mass, const TransientOptions& options, double* spike = nullptr) {
  Model model;
  const NodeId top = add(model, drawn.building).top();
  if (body_mass > 0.0) add_body(model, body_mass, top);
  const CaseResult result = run_case(model, drawn.motion, {.transient = options, .error_bars = ErrorBarMode::never});
  Peaks values;
  for (const Peak& peak : result.peaks) {
    if (peak.where == "far apart") continue;
    if (!peak.where.starts_with("body"))
      values[peak.quantity + " " + peak.where] = peak.magnitude();
    else if (spike != nullptr && peak.quantity == "absolute_acceleration")
      *spike = peak.magnitude();
  }
  return values;
}

double largest_change(const Peaks& of, const Peaks& from) {
  double largest = 0.0;
  for (const auto& [name, value] : from) largest = std::max(largest, std::abs(of.at(name) / value - 1.0));
  return largest;
}

// All bodies share their steps, so that those of a contact make the building more accurate. They must not make it less
// so: a spike that loosened the tolerance multiplied the error by ten and more.
TEST(ErrorScales, ABodyElsewhereDoesNotMakeABuildingLessAccurate) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Case model = drawn(seed);
    const Peaks right = peaks(model, 0.0, {.tolerance = 1e-8});
    const double alone = largest_change(peaks(model, 0.0, {}), right);
    for (const double mass : {1e4, 1e3, 1e2}) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", body of " << mass << " kg");
      double spike = 0.0;
      const double beside = largest_change(peaks(model, mass, {}, &spike), right);
      // A quarter for other steps, and a tenth of the tolerance where both errors are small.
      EXPECT_LT(beside, 1.25 * alone + 0.1 * TransientOptions{}.tolerance);
      EXPECT_GT(spike, 10.0);
    }
  }
}

TEST(ErrorScales, WhatFollowsAnImpactIsAccurate) {
  // A light body flies against a floor at rest and away for good. The floor's acceleration is some twenty-five times
  // that of the free vibration it is left with.
  constexpr double mass = 1e4, period = 0.1, frequency = 2.0 * std::numbers::pi / period;
  Model model;
  const NodeId floor = add(model, Oscillator{.name = "floor", .mass = mass, .frequency = frequency});
  const NodeId body = add(model, Node{.name = "body", .mass = 100 * kg, .initial_velocity = -10 * m / s});
  add(model, Gap{.name = "gap",
                 .left = floor,
                 .right = body,
                 .clearance = 10 * cm,
                 .law = LinearElastic{.stiffness = 1e9 * N / m}});
  double separation = -1.0, displacement = 0.0, velocity = 0.0, largest_error = 0.0, spike = 0.0;
  Watch watch{[&](const StepView& view) {
    const MotionState& state = view.state.motion();
    spike = std::max(spike, std::abs(state.acceleration[0]));
    if (watch.events == 2 && separation < 0.0) {
      separation = state.time;
      displacement = state.displacement[0];
      velocity = state.velocity[0];
    } else if (watch.events == 2) {
      const double angle = frequency * (state.time - separation);
      const double expected = displacement * std::cos(angle) + velocity / frequency * std::sin(angle);
      largest_error = std::max(largest_error, std::abs(state.displacement[0] - expected));
    }
  }};
  Transient analysis{model, still_ground(2 * s, interval * s), {}};
  analysis.attach(watch);
  analysis.run();
  ASSERT_EQ(watch.events, 2);
  const double amplitude = std::hypot(displacement, velocity / frequency);
  EXPECT_GT(spike, 10.0 * frequency * frequency * amplitude);
  // A step's error of acceleration is (w h)^3/72 of it, at most twice the tolerance; the error of period is (w
  // h)^4/480, which adds up over twenty cycles.
  const double phase = std::cbrt(72.0 * 2.0 * TransientOptions{}.tolerance);
  EXPECT_LT(largest_error / amplitude, std::pow(phase, 4) / 480.0 * frequency * 2.0);
}

}  // namespace
}  // namespace moat
