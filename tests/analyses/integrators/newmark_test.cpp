// Linear structures against exact solutions.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis_testing.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;
using namespace testing;

constexpr double angular_frequency = 2.0 * pi;  // of oscillator() by default: a period of 1 s

// Largest differences from u(t) and v(t) over the whole history.
struct Errors {
  double displacement = 0.0, velocity = 0.0, acceleration = 0.0;
};

template <class Exact>
Errors errors(const Model& model, const GroundMotion& motion, Newmark scheme, double step, Exact exact) {
  Transient analysis{model, motion, {.integrator = scheme, .step = step * s}};
  Errors largest;
  while (!analysis.finished()) {
    analysis.advance();
    const MotionState& state = analysis.state().motion();
    const auto [u, v, a] = exact(state.time);
    largest.displacement = std::max(largest.displacement, std::abs(state.displacement[0] - u));
    largest.velocity = std::max(largest.velocity, std::abs(state.velocity[0] - v));
    largest.acceleration = std::max(largest.acceleration, std::abs(state.acceleration[0] - a));
  }
  EXPECT_DOUBLE_EQ(analysis.state().time(), analysis.end_time());
  return largest;
}

struct Motion {
  double u, v, a;
};

TEST(Newmark, PeriodErrorIsThatOfTheScheme) {
  // Relative lengthening of the period: (w h)^2 / 12 for average, (w h)^2 / 24 for linear acceleration.
  const double step = 0.01, cycles = 3.0;
  for (const auto& [scheme, divisor] :
       {std::pair{Newmark::average_acceleration(), 12.0}, std::pair{Newmark::linear_acceleration(), 24.0}}) {
    Model model = oscillator({.displacement = 0.03});
    Transient analysis{model, still_ground(cycles * s), {.integrator = scheme, .step = step * s}};
    while (!analysis.finished()) analysis.advance();
    // At the end the exact oscillator is at its turning point; the numerical one lags by a phase.
    const double lag = std::atan2(analysis.state().motion().velocity[0] / angular_frequency,
                                  analysis.state().motion().displacement[0]);
    const double expected = 2.0 * pi * cycles * std::pow(angular_frequency * step, 2) / divisor;
    EXPECT_NEAR(lag, expected, 0.01 * expected) << "beta = " << *scheme.beta;
  }
}

TEST(Newmark, RampedGroundAcceleration) {
  // a_g = j t from rest: u = -j/w^2 (t - sin(w t)/w).
  const double jerk = 2.0, w = angular_frequency;
  const auto exact = [&](double t) {
    return Motion{-jerk / (w * w) * (t - std::sin(w * t) / w), -jerk / (w * w) * (1.0 - std::cos(w * t)),
                  -jerk / w * std::sin(w * t)};
  };
  const GroundMotion ramp = sampled("ramp", 2 * s, 50 * ms, [&](double t) { return jerk * t; });
  for (const Newmark scheme : {Newmark::average_acceleration(), Newmark::linear_acceleration()}) {
    const Errors coarse = errors(oscillator({}), ramp, scheme, 0.01, exact);
    const Errors fine = errors(oscillator({}), ramp, scheme, 0.005, exact);
    EXPECT_LT(fine.displacement, 2e-4 * jerk / (w * w)) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05) << "beta = " << *scheme.beta;
    EXPECT_NEAR(order(coarse.acceleration, fine.acceleration), 2.0, 0.05) << "beta = " << *scheme.beta;
  }
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
    return errors(oscillator({.damping_ratio = ratio, .displacement = 0.03}), still_ground(2 * s),
                  Newmark::average_acceleration(), step, exact);
  };
  const Errors coarse = at(0.01), fine = at(0.005);
  EXPECT_NEAR(order(coarse.displacement, fine.displacement), 2.0, 0.05);
  EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2.0, 0.05);
}

TEST(Newmark, AStepThatDoesNotDivideTheDurationEndsAtTheEnd) {
  Model model = oscillator({.displacement = 0.03});
  Transient analysis{model, still_ground(1 * s), {.step = 30 * ms}};
  std::vector<double> times;
  while (!analysis.finished()) {
    analysis.advance();
    times.push_back(analysis.state().time());
  }
  ASSERT_EQ(times.size(), 34u);
  for (std::size_t i = 0; i < 33; ++i) EXPECT_DOUBLE_EQ(times[i], 0.03 * static_cast<double>(i + 1));
  EXPECT_DOUBLE_EQ(times.back(), 1.0);
}

TEST(Newmark, ALinearModelNeedsOneFactorisation) {
  Model model = oscillator({.displacement = 0.03});
  Transient analysis{model, still_ground(1 * s), {.step = 10 * ms}};
  while (!analysis.finished()) analysis.advance();
  EXPECT_EQ(analysis.statistics().factorisations, 1);
  EXPECT_EQ(analysis.statistics().accepted_steps, 100);
  EXPECT_EQ(analysis.statistics().rejected_steps, 0);
  EXPECT_EQ(analysis.statistics().newton_iterations, 100);
}

}  // namespace
}  // namespace moat
