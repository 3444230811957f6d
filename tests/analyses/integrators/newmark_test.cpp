// Linear structures against exact solutions.

#include "analyses/integrators/newmark.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/spring.hpp"
#include "elements/line/viscous_damper.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;
using testing::constant_acceleration;
using testing::order;
using testing::still_ground;
using testing::Watch;

constexpr double mass = 2000.0, angular_frequency = 2.0 * pi;  // a period of 1 s

// A mass on a spring, with damping ratio `damping`.
Model oscillator(Length displacement = 0 * m, Speed velocity = 0 * m / s, double damping = 0.0) {
  Model model;
  const NodeId node =
      add(model,
          Node{.name = "mass", .mass = mass * kg, .initial_displacement = displacement, .initial_velocity = velocity});
  add(model, ShearSpring{.name = "spring",
                         .lower = ground,
                         .upper = node,
                         .stiffness = mass * angular_frequency * angular_frequency * N / m});
  if (damping > 0.0)
    add(model, ViscousDamper{.name = "damper",
                             .lower = ground,
                             .upper = node,
                             .damping = 2.0 * damping * mass * angular_frequency * N * s / m});
  return model;
}

// Largest differences from u(t) and v(t) over the whole history.
struct Errors {
  double displacement = 0.0, velocity = 0.0, acceleration = 0.0;
};

template <class Exact>
Errors errors(Model model, const GroundMotion& motion, Newmark scheme, double step, Exact exact) {
  Transient analysis{model, motion, {.integrator = scheme, .step = step * s}};
  Errors largest;
  while (!analysis.finished()) {
    analysis.advance();
    const MotionState& state = model.state();
    const auto [u, v, a] = exact(state.time);
    largest.displacement = std::max(largest.displacement, std::abs(state.displacement[0] - u));
    largest.velocity = std::max(largest.velocity, std::abs(state.velocity[0] - v));
    largest.acceleration = std::max(largest.acceleration, std::abs(state.acceleration[0] - a));
  }
  EXPECT_DOUBLE_EQ(model.state().time, analysis.end_time());
  return largest;
}

struct Motion {
  double u, v, a;
};

Motion free_vibration(double t) {
  const double w = angular_frequency, u0 = 0.03, v0 = -0.5;
  const double u = u0 * std::cos(w * t) + v0 / w * std::sin(w * t);
  return {u, -w * u0 * std::sin(w * t) + v0 * std::cos(w * t), -w * w * u};
}

TEST(Newmark, FreeVibrationIsSecondOrder) {
  for (const Newmark scheme : {Newmark::average_acceleration(), Newmark::linear_acceleration()}) {
    const auto at = [&](double step) {
      return errors(oscillator(3 * cm, -0.5 * m / s), still_ground(3 * s), scheme, step, free_vibration);
    };
    const Errors coarse = at(0.01), fine = at(0.005);
    EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2.0, 0.05) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.acceleration, fine.acceleration), 2.0, 0.05) << "beta = " << *scheme.beta;
  }
}

TEST(Newmark, PeriodErrorIsThatOfTheScheme) {
  // Relative lengthening of the period: (w h)^2 / 12 for average, (w h)^2 / 24 for linear acceleration.
  const double step = 0.01, cycles = 3.0;
  for (const auto& [scheme, divisor] :
       {std::pair{Newmark::average_acceleration(), 12.0}, std::pair{Newmark::linear_acceleration(), 24.0}}) {
    Model model = oscillator(3 * cm);
    Transient analysis{model, still_ground(cycles * s), {.integrator = scheme, .step = step * s}};
    while (!analysis.finished()) analysis.advance();
    // At the end the exact oscillator is at its turning point; the numerical one lags by a phase.
    const double lag = std::atan2(model.state().velocity[0] / angular_frequency, model.state().displacement[0]);
    const double expected = 2.0 * pi * cycles * std::pow(angular_frequency * step, 2) / divisor;
    EXPECT_NEAR(lag, expected, 0.01 * expected) << "beta = " << *scheme.beta;
  }
}

TEST(Newmark, AverageAccelerationConservesEnergyExactly) {
  Model model;
  NodeId below = ground;
  for (int i = 1; i <= 5; ++i) {
    const NodeId node = add(model, Node{.name = "floor " + std::to_string(i),
                                        .mass = (100.0 + 30.0 * i) * tonne,
                                        .initial_displacement = i % 2 * cm,
                                        .initial_velocity = 0.1 * i * m / s});
    add(model, ShearSpring{.name = "storey " + std::to_string(i),
                           .lower = below,
                           .upper = node,
                           .stiffness = (100.0 + 50.0 * i) * MN / m});
    below = node;
  }
  // A step of a third of the shortest period: nothing is accurate any more, but energy.
  Transient analysis{model, still_ground(20 * s), {.step = 40 * ms}};
  const auto energy = [&] {
    const MotionState& state = model.state();
    double sum = 0.0;
    for (int i = 0; i < 5; ++i) sum += 0.5 * model.masses()[i] * state.velocity[i] * state.velocity[i];
    for (const auto& block : model.blocks())
      for (std::size_t e = 0; e < block->size(); ++e)
        sum += 0.5 * block->results().forces[e] * block->results().deformations[e];
    return sum;
  };
  const double start = energy();
  ASSERT_GT(start, 0.0);
  double largest = 0.0;
  while (!analysis.finished()) {
    analysis.advance();
    largest = std::max(largest, std::abs(energy() / start - 1.0));
  }
  EXPECT_EQ(analysis.statistics().accepted_steps, 500);
  EXPECT_LT(largest, 1e-10);
}

TEST(Newmark, RampedGroundAcceleration) {
  // a_g = j t from rest: u = -j/w^2 (t - sin(w t)/w).
  const double jerk = 2.0, w = angular_frequency;
  const auto exact = [&](double t) {
    return Motion{-jerk / (w * w) * (t - std::sin(w * t) / w), -jerk / (w * w) * (1.0 - std::cos(w * t)),
                  -jerk / w * std::sin(w * t)};
  };
  std::vector<double> samples;
  for (int i = 0; i <= 40; ++i) samples.push_back(jerk * 0.05 * i);
  const GroundMotion ramp{"ramp", 0.05, samples};
  for (const Newmark scheme : {Newmark::average_acceleration(), Newmark::linear_acceleration()}) {
    const Errors coarse = errors(oscillator(), ramp, scheme, 0.01, exact);
    const Errors fine = errors(oscillator(), ramp, scheme, 0.005, exact);
    EXPECT_LT(fine.displacement, 2e-4 * jerk / (w * w)) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.acceleration, fine.acceleration), 2.0, 0.05) << "beta = " << *scheme.beta;
  }
}

TEST(Newmark, GroundAccelerationThatStartsAbruptly) {
  // a_g = a0 from the first instant: the mass has -a0 at t = 0 already, u = -a0/w^2 (1 - cos(w t)).
  const double a0 = 1.5, w = angular_frequency;
  const auto exact = [&](double t) {
    return Motion{-a0 / (w * w) * (1.0 - std::cos(w * t)), -a0 / w * std::sin(w * t), -a0 * std::cos(w * t)};
  };
  Model model = oscillator();
  const Transient analysis{model, constant_acceleration(a0, 1 * s), {.step = 5 * ms}};
  EXPECT_EQ(model.state().acceleration[0], -a0);
  const GroundMotion motion = constant_acceleration(a0, 2 * s);
  const Errors coarse = errors(oscillator(), motion, Newmark::average_acceleration(), 0.01, exact);
  const Errors fine = errors(oscillator(), motion, Newmark::average_acceleration(), 0.005, exact);
  EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05);
  EXPECT_NEAR(order(coarse.acceleration, fine.acceleration), 2.0, 0.05);
}

TEST(Newmark, DampedVibrationIsSecondOrder) {
  const double ratio = 0.1, w = angular_frequency, damped = w * std::sqrt(1.0 - ratio * ratio), u0 = 0.03;
  const auto exact = [&](double t) {
    const double decay = std::exp(-ratio * w * t), c = std::cos(damped * t), sine = std::sin(damped * t);
    const double u = u0 * decay * (c + ratio * w / damped * sine);
    const double v = -u0 * decay * w * w / damped * sine;
    return Motion{u, v, -w * w * u - 2.0 * ratio * w * v};
  };
  const auto at = [&](double step) {
    return errors(oscillator(3 * cm, 0 * m / s, ratio), still_ground(2 * s), Newmark::average_acceleration(), step,
                  exact);
  };
  const Errors coarse = at(0.01), fine = at(0.005);
  EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05);
  EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2.0, 0.05);
}

TEST(Newmark, StaticLimit) {
  // Pushed slowly and well damped, the mass stays where the spring balances the inertia force.
  Model model = oscillator(0 * m, 0 * m / s, 0.5);
  std::vector<double> samples{0.0, 1.0, 1.0};
  Transient analysis{model, GroundMotion{"slow push", 20.0, samples}, {.step = 50 * ms}};
  while (!analysis.finished()) analysis.advance();
  EXPECT_NEAR(model.state().displacement[0], -1.0 / (angular_frequency * angular_frequency), 1e-10);
  EXPECT_NEAR(model.state().velocity[0], 0.0, 1e-9);
  EXPECT_NEAR(model.state().acceleration[0], 0.0, 1e-8);
}

TEST(Newmark, AStepThatDoesNotDivideTheDurationEndsAtTheEnd) {
  Model model = oscillator(3 * cm);
  Transient analysis{model, still_ground(1 * s), {.step = 30 * ms}};
  std::vector<double> times;
  while (!analysis.finished()) {
    analysis.advance();
    times.push_back(model.state().time);
  }
  ASSERT_EQ(times.size(), 34u);
  for (std::size_t i = 0; i < 33; ++i) EXPECT_DOUBLE_EQ(times[i], 0.03 * static_cast<double>(i + 1));
  EXPECT_DOUBLE_EQ(times.back(), 1.0);
}

TEST(Newmark, ALinearModelNeedsOneFactorisation) {
  Model model = oscillator(3 * cm);
  Transient analysis{model, still_ground(1 * s), {.step = 10 * ms}};
  while (!analysis.finished()) analysis.advance();
  EXPECT_EQ(analysis.statistics().factorisations, 1);
  EXPECT_EQ(analysis.statistics().accepted_steps, 100);
  EXPECT_EQ(analysis.statistics().rejected_steps, 0);
  EXPECT_EQ(analysis.statistics().newton_iterations, 100);
}

// F = k d (1 + (d/d0)^2), which stiffens smoothly.
struct Duffing {
  using State = NoState;
  static constexpr double stiffness = mass * angular_frequency * angular_frequency, d0 = 0.05;
  static double square(double d) { return d * d / (d0 * d0); }
  Response evaluate(const State&, double d, double, State&) const {
    return {stiffness * d * (1.0 + square(d)), stiffness * (1.0 + 3.0 * square(d)), 0.0};
  }
  double stored_energy(const State&, double d) const { return stiffness * d * d * (0.5 + 0.25 * square(d)); }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness; }
};

// The iteration starts from the cubic through the accelerations and jerks of the last two states. From the tangent at
// the last one 30 of these steps take two iterations.
TEST(Newmark, ASmoothForceNeedsOneIteration) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = mass * kg, .initial_displacement = 3 * cm});
  add(model, Spring<Duffing>{.name = "spring", .lower = ground, .upper = node, .law = {}});
  std::vector<double> samples;
  for (int i = 0; i <= 100; ++i) samples.push_back(2.0 * std::sin(0.13 * i));
  Transient analysis{
      model, GroundMotion{"waves", 0.02, samples}, {.integrator = Newmark::fourth_order(), .step = 20 * ms}};
  while (!analysis.finished()) analysis.advance();
  EXPECT_EQ(analysis.statistics().accepted_steps, 100);
  EXPECT_LE(analysis.statistics().newton_iterations, 102);
}

}  // namespace
}  // namespace moat
