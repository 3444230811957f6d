// The energy balance of exact steps: input, residual, and no warning without reason.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double mass = 1e5;  // kg
const TransientOptions exact{.integrator = ExactBetweenEvents{}};

Model on_bearings() {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass * kg});
  add(model, LeadRubberBearing{.upper = body,
                               .yield_force = 0.05 * mass * 9.81 * N,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = mass * 4.0 * N / m});
  return model;
}

// Two sines that have nothing in common, from zero to zero; 5 s.
GroundMotion shaking(double interval) {
  return sampled("two sines", 5 * s, interval * s, [](double t) {
    return std::sin(0.2 * pi * t) * (3.0 * std::sin(9.1 * t) + 2.0 * std::sin(22.7 * t));
  });
}

CaseResult run(const Model& model, const GroundMotion& motion, TransientOptions options) {
  return run_case(model, motion, {.transient = options, .error_bars = ErrorBarMode::never});
}

// Newmark's steps with the tight tolerance are right to about a hundredth of a millionth of the largest input.
constexpr double as_accurate_as_newmark = 1e-6;
constexpr double round_off = 1e-11;

// Of the largest input. Work and input are integrals of order six along the motion inside a step; the constants of such
// formulas are below one ten-thousandth.
double largest_residual(double frequency, double interval) {
  return round_off + 1e-4 * std::pow(frequency * interval, 6);
}

void expect_right(const CaseResult& result, const CaseResult& tight, double largest_residual) {
  const EnergyBalance &e = result.energy, &t = tight.energy;
  EXPECT_NEAR(e.input, t.input, as_accurate_as_newmark * t.largest_input);
  EXPECT_NEAR(e.viscous, t.viscous, as_accurate_as_newmark * t.largest_input);
  EXPECT_NEAR(e.hysteretic, t.hysteretic, as_accurate_as_newmark * t.largest_input);
  EXPECT_LT(std::abs(e.equation_residual), largest_residual * e.largest_input);
  EXPECT_LT(std::abs(e.integration_error), as_accurate_as_newmark * e.largest_input);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
}

TEST(ExactEnergy, OfADampedOscillator) {
  const Model model = oscillator({.frequency = 2.0 * pi / 0.25, .damping_ratio = 0.05});
  for (const double interval : {0.005, 0.01}) {
    SCOPED_TRACE(interval);
    expect_right(run(model, shaking(interval), exact), run(model, shaking(interval), {.tolerance = 1e-9}),
                 largest_residual(2.0 * pi / 0.25, interval));
  }
}

TEST(ExactEnergy, OfABearingWhoseYieldIsLocated) {
  const double frequency = std::sqrt(0.05 * 9.81 / 0.01);  // before yield
  for (const double interval : {0.01, 0.02}) {
    SCOPED_TRACE(interval);
    const CaseResult result = run(on_bearings(), shaking(interval), exact);
    expect_right(result, run(on_bearings(), shaking(interval), {.tolerance = 1e-9}),
                 largest_residual(frequency, interval) + Bilinear::threshold);
    EXPECT_GT(result.energy.hysteretic, 0.0);
  }
}

// The ground pushes over u = -(a/w^2) (1 - cos wt) and does no work afterwards; the last case has two samples.
TEST(ExactEnergy, OfABoxPulseIsTheClosedForm) {
  struct Case {
    double period, pushed, interval;  // s
  };
  for (const auto& [period, pushed, interval] :
       {Case{0.5, 0.2, 5e-3}, Case{0.5, 0.2, 10e-3}, Case{0.5, 0.2, 20e-3}, Case{2.0, 0.1, 0.1}}) {
    SCOPED_TRACE(interval);
    const double a = 3.0, frequency = 2.0 * pi / period;
    const double input = mass * a * a / (frequency * frequency) * (1.0 - std::cos(frequency * pushed));
    const CaseResult result =
        run(oscillator({.frequency = frequency}), constant_acceleration(a, pushed * s, interval * s),
            {.integrator = ExactBetweenEvents{}, .end = 2 * s});
    const double error = largest_residual(frequency, interval) * input;
    EXPECT_NEAR(result.energy.input, input, error);
    EXPECT_NEAR(result.energy.kinetic + result.energy.strain, input, error);
    EXPECT_LT(std::abs(result.energy.equation_residual), error);
  }
}

TEST(ExactEnergy, LinearModelsHaveNoWarning) {
  for (const double period : {0.1, 0.25, 0.5, 2.0})
    for (const double ratio : {0.0, 0.02, 0.2})
      for (const double interval : {0.005, 0.01, 0.02}) {
        SCOPED_TRACE(::testing::Message() << "period " << period << ", ratio " << ratio << ", interval " << interval);
        const CaseResult result =
            run(oscillator({.frequency = 2.0 * pi / period, .damping_ratio = ratio}), shaking(interval), exact);
        EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
      }
  Model model;
  add(model, paper_building_on_fixed_base());
  const CaseResult result = run(model, shaking(0.02), exact);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
}

}  // namespace
}  // namespace moat
