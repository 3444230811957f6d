// The fourth-order scheme: order, steps of changing length, stability.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "analysis_testing.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// Two equal masses, springs k and dampers c in proportion, below, between and above: modes (1, 1) and (1, -1) with
// w^2 = k/m and 3 k/m, 2 z w = c/m and 3 c/m.
constexpr double mass = 1e4, stiffness = 1e4 * 60.0, damping = 1e4 * 0.8;
constexpr double ramp = 3.0;  // m/s^3, of the ground
constexpr double displacements[] = {0.03, -0.01}, velocities[] = {0.1, 0.4};

Model two_masses() {
  Model model;
  const NodeId one = add(model, Node{.name = "one",
                                     .mass = mass * kg,
                                     .initial_displacement = displacements[0] * m,
                                     .initial_velocity = velocities[0] * m / s});
  const NodeId two = add(model, Node{.name = "two",
                                     .mass = mass * kg,
                                     .initial_displacement = displacements[1] * m,
                                     .initial_velocity = velocities[1] * m / s});
  const auto join = [&](const std::string& name, NodeId lower, NodeId upper) {
    add(model, ShearSpring{.name = name, .lower = lower, .upper = upper, .stiffness = stiffness * N / m});
    add(model, ViscousDamper{.name = name + " damper", .lower = lower, .upper = upper, .damping = damping * N * s / m});
  };
  join("left", ground, one);
  join("middle", one, two);
  join("right", ground, two);
  return model;
}

struct Motion {
  double u, v, a;
};

// q'' + c q' + k q = - r t from q0, v0.
Motion mode(double k, double c, double r, double q0, double v0, double t) {
  // Particular solution: - r t/k + r c/k^2.
  const double p0 = r * c / (k * k), p1 = -r / k;
  const std::complex<double> s{-0.5 * c, std::sqrt(k - 0.25 * c * c)};
  // q = p + Re(z e^(s t)).
  const double x = q0 - p0, y = v0 - p1;
  const std::complex<double> z{x, (s.real() * x - y) / s.imag()};
  const std::complex<double> e = z * std::exp(s * t);
  return {p0 + p1 * t + e.real(), p1 + (s * e).real(), (s * s * e).real()};
}

std::array<Motion, 2> exact(double t) {
  const double k = stiffness / mass, c = damping / mass;
  const Motion sum =
      mode(k, c, ramp, 0.5 * (displacements[0] + displacements[1]), 0.5 * (velocities[0] + velocities[1]), t);
  const Motion difference = mode(3.0 * k, 3.0 * c, 0.0, 0.5 * (displacements[0] - displacements[1]),
                                 0.5 * (velocities[0] - velocities[1]), t);
  return {Motion{sum.u + difference.u, sum.v + difference.v, sum.a + difference.a},
          Motion{sum.u - difference.u, sum.v - difference.v, sum.a - difference.a}};
}

GroundMotion ramped(double duration, double interval) {
  return sampled("ramp", duration * s, interval * s, [](double t) { return ramp * t; });
}

// Largest errors over all steps, and the lengths of the steps.
struct Errors {
  double u = 0.0, v = 0.0, a = 0.0;
  long steps = 0;
  double shortest = 1e300, longest = 0.0;
};

Errors errors(double interval, const TransientOptions& options) {
  Model model = two_masses();
  Errors largest;
  double before = 0.0;
  Watch watch{[&](const StepView& view) {
    const MotionState& state = view.state.motion();
    const std::array<Motion, 2> right = exact(state.time);
    for (int i = 0; i < 2; ++i) {
      const Motion& each = right[static_cast<std::size_t>(i)];
      largest.u = std::max(largest.u, std::abs(state.displacement[i] - each.u));
      largest.v = std::max(largest.v, std::abs(state.velocity[i] - each.v));
      largest.a = std::max(largest.a, std::abs(state.acceleration[i] - each.a));
    }
    if (state.time > before) {
      largest.shortest = std::min(largest.shortest, state.time - before);
      largest.longest = std::max(largest.longest, state.time - before);
    }
    before = state.time;
  }};
  Transient analysis{model, ramped(2.0, interval), options};
  analysis.attach(watch);
  analysis.run();
  largest.steps = analysis.statistics().accepted_steps;
  return largest;
}

TEST(FourthOrder, ConvergesInDisplacementVelocityAndAcceleration) {
  Errors before;
  for (const double step : {20e-3, 10e-3, 5e-3, 2.5e-3}) {
    SCOPED_TRACE(step);
    const Errors now =
        errors(step, {.integrator = Newmark::fourth_order(), .step = step * s, .force_tolerance = 1e-14});
    if (before.u > 0.0) {
      EXPECT_NEAR(order(before.u, now.u), 4.0, 0.1);
      EXPECT_NEAR(order(before.v, now.v), 4.0, 0.1);
      EXPECT_NEAR(order(before.a, now.a), 4.0, 0.1);
    }
    before = now;
  }
}

TEST(FourthOrder, AdaptedStepsKeepIt) {
  // The error of acceleration in a step is of third order in its length: a tolerance eight times smaller halves the
  // steps, though not all of them at once, and their sum falls by sixteen.
  const auto run = [](double tolerance) {
    const Errors of = errors(0.1, {.tolerance = tolerance, .force_tolerance = 1e-13});
    EXPECT_LT(of.shortest, 0.6 * of.longest) << "steps change";
    return of;
  };
  const Errors coarse = run(1.6e-3), fine = run(1.6e-3 / 512.0);
  const double halvings = std::log2(static_cast<double>(fine.steps) / static_cast<double>(coarse.steps));
  EXPECT_NEAR(halvings, 3.0, 0.3);
  EXPECT_GT(order(coarse.u, fine.u) / halvings, 3.7);
  EXPECT_GT(order(coarse.v, fine.v) / halvings, 3.7);
  EXPECT_GT(order(coarse.a, fine.a) / halvings, 3.7);
}

// Largest displacement over so many steps of an undamped vibration, at this h w, in amplitudes.
double largest_displacement(double phase, int steps) {
  constexpr double amplitude = 1e-3;  // m
  constexpr double step = 0.01;
  Model model = oscillator({.frequency = phase / step, .displacement = amplitude});
  double largest = 0.0;
  Watch watch{
      [&](const StepView& view) { largest = std::max(largest, std::abs(view.state.motion().displacement[0])); }};
  Transient analysis{
      model, still_ground(steps * step * s, step * s), {.integrator = Newmark::fourth_order(), .step = step * s}};
  analysis.attach(watch);
  analysis.run();
  EXPECT_EQ(analysis.statistics().accepted_steps, steps);
  return largest / amplitude;
}

// Without damping the scheme conserves an energy up to h w = sqrt(6) = 2.449: amplitudes stay constant, but for
// round-off, and grow beyond it.
TEST(FourthOrder, IsStableUpToItsBound) {
  EXPECT_NEAR(StepScheme::fourth_order().stability_limit(), std::sqrt(6.0), 1e-12);
  for (const double phase : {0.5, 1.0, 1.8, 2.2, 2.39, 2.44})
    EXPECT_NEAR(largest_displacement(phase, 10000), 1.0, 1e-6) << phase;
}

TEST(FourthOrder, IsUnstableBeyondIt) { EXPECT_GT(largest_displacement(2.5, 30), 1e3); }

}  // namespace
}  // namespace moat
