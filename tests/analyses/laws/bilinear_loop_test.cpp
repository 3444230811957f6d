// The hysteresis loop of a bearing, through the whole model.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analyses/time_history/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/line/lead_rubber_bearing.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;
using testing::Watch;

// k1 = 193 MN/m, k2 = 19.3 MN/m, d_y = 1 cm.
constexpr double yield_force = 1.93e6, yield_displacement = 0.01, post_yield = 1.93e7;
constexpr double initial = yield_force / yield_displacement, sliding = initial - post_yield;

TEST(BilinearLoop, AreaOfSlowCyclesIsTheClosedForm) {
  // Ground acceleration so slow that the bearing carries all of m a_g: the amplitude follows from the force.
  const double mass = 3.05e6, amplitude = 0.08;
  const double force = post_yield * amplitude + sliding * yield_displacement;
  const double period = 200.0;
  std::vector<double> samples;
  for (int i = 0; i <= 5000; ++i) samples.push_back(-force / mass * std::sin(2.0 * pi * 0.05 * i / period));
  const GroundMotion motion{"slow cycles", 0.05, std::move(samples)};  // 1.25 cycles

  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = mass * kg});
  add(model, LeadRubberBearing{.upper = base,
                               .yield_force = yield_force * N,
                               .yield_displacement = yield_displacement * m,
                               .post_yield_stiffness = post_yield * N / m});
  double area = 0.0, last_force = 0.0, last_deformation = 0.0, largest = 0.0;
  Watch watch{[&](const StepView& view) {
    const ElementBlock& bearing = *view.model.blocks().front();
    const double deformation = bearing.results().deformations[0], pull = bearing.results().forces[0];
    largest = std::max(largest, std::abs(deformation));
    // One whole cycle, from the first turning point to the one a period later.
    if (view.model.state().time > period / 4.0 + 1e-9)
      area += 0.5 * (pull + last_force) * (deformation - last_deformation);
    last_force = pull;
    last_deformation = deformation;
  }};
  Transient analysis{model, motion, {.step = 25 * ms}};
  analysis.attach(watch);
  analysis.run();
  // Inertia and free vibration change the force by less than 1 %.
  EXPECT_NEAR(largest, amplitude, 0.01 * amplitude);
  const double expected = 4.0 * sliding * yield_displacement * (amplitude - yield_displacement);
  EXPECT_NEAR(area, expected, 0.01 * expected);
}

TEST(BilinearLoop, AFreeBodyOnABearingLosesWhatTheLoopTakes) {
  // From rest far beyond yield: released, it swings, and stops where the loops have taken all that they can.
  // Kinetic energy at any time = drop of stored energy - dissipated, with dissipation from the slip.
  const double mass = 3.05e6;
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = mass * kg, .initial_velocity = 1.2 * m / s});
  add(model, LeadRubberBearing{.upper = base,
                               .yield_force = yield_force * N,
                               .yield_displacement = yield_displacement * m,
                               .post_yield_stiffness = post_yield * N / m});
  double work = 0.0, last_force = 0.0, last_deformation = 0.0, largest_error = 0.0;
  const double start = 0.5 * mass * 1.2 * 1.2;
  Watch watch{[&](const StepView& view) {
    const ElementBlock& bearing = *view.model.blocks().front();
    const double deformation = bearing.results().deformations[0], pull = bearing.results().forces[0];
    work += 0.5 * (pull + last_force) * (deformation - last_deformation);
    last_force = pull;
    last_deformation = deformation;
    const double speed = view.model.state().velocity[0];
    largest_error = std::max(largest_error, std::abs(0.5 * mass * speed * speed + work - start));
  }};
  Transient analysis{model, testing::still_ground(20 * s), {.step = 10 * ms}};
  analysis.attach(watch);
  analysis.run();
  // Average acceleration: the change of kinetic energy is mean force times displacement, to round-off, through yield
  // and unloading too.
  EXPECT_LT(largest_error, 1e-8 * start);
  EXPECT_LT(0.5 * mass * std::pow(model.state().velocity[0], 2), 0.05 * start);
}

}  // namespace
}  // namespace moat
