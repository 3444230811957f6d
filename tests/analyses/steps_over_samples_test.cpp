// Steps of fourth order that are longer than the interval of the motion's samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analyses/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double interval = 5e-3;  // s

// Three sines, the fastest of 14 Hz, with a noise of 2 % from sample to sample.
GroundMotion rough_motion() {
  std::vector<double> samples;
  for (int i = 0; i <= 2000; ++i) {
    const double t = interval * i;
    samples.push_back(2.0 * std::sin(5.0 * t) + 0.7 * std::sin(31.0 * t + 1.0) + 0.3 * std::sin(88.0 * t) +
                      0.06 * std::sin(1234.5 * i * i));
  }
  return GroundMotion{"rough", interval, samples};
}

Model oscillator(double period, double damping_ratio) {
  const double frequency = 2.0 * std::numbers::pi / period, mass = 1e4;
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = mass * kg});
  add(model,
      ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = mass * frequency * frequency * N / m});
  if (damping_ratio > 0.0)
    add(model, ViscousDamper{.name = "damper",
                             .lower = ground,
                             .upper = body,
                             .damping = 2.0 * damping_ratio * mass * frequency * N * s / m});
  return model;
}

CaseResult result_of(Model model, const TransientOptions& options) {
  return run_case(model, rough_motion(),
                  {.transient = options, .history_interval = interval * s, .error_bars = ErrorBarMode::never});
}

double peak(const CaseResult& result, const std::string& quantity) {
  for (const Peak& each : result.peaks)
    if (each.quantity == quantity) return each.value;
  ADD_FAILURE() << "no " << quantity;
  return 0.0;
}

const std::vector<double>& column(const CaseResult& result, const std::string& quantity) {
  for (const Column& each : result.histories.columns)
    if (each.quantity == quantity) return each.values;
  throw std::runtime_error{"no column " + quantity};
}

// Tolerances so loose that every step has the largest length.
TransientOptions steps_of(double length) { return {.tolerance = 0.99, .largest_step = length * s}; }

// A body that nothing holds: its motion is minus that of the ground.
TEST(StepsOverSamples, FollowTheGroundExactly) {
  const GroundMotion motion = rough_motion();
  const std::vector<double> velocity = motion.velocity(), displacement = motion.displacement();
  for (const double length : {10e-3, 40e-3, 160e-3}) {
    SCOPED_TRACE(length);
    const CaseResult result = result_of(oscillator(1e6, 0.0), steps_of(length));
    EXPECT_NEAR(result.solver.longest_step, length, 1e-12);
    EXPECT_LT(result.solver.accepted_steps, 1.1 * 10.0 / length + 10.0);
    const std::vector<double>&u = column(result, "displacement"), &v = column(result, "velocity"),
          &a = column(result, "ground_acceleration");
    ASSERT_EQ(u.size(), displacement.size());
    const double largest_u = motion.peak_displacement().si(), largest_v = motion.peak_velocity().si();
    for (std::size_t i = 0; i < u.size(); ++i) {
      ASSERT_NEAR(u[i], -displacement[i], 1e-9 * largest_u) << i;
      ASSERT_NEAR(v[i], -velocity[i], 1e-9 * largest_v) << i;
      ASSERT_NEAR(a[i], motion.samples()[i], 1e-12) << i;
    }
    // All energy is kinetic.
    EXPECT_LT(std::abs(result.energy.equation_residual), 1e-3 * result.energy.largest_input);
  }
}

TEST(StepsOverSamples, AreOfFourthOrder) {
  for (const double damping_ratio : {0.0, 0.05}) {
    SCOPED_TRACE(damping_ratio);
    const Model model = oscillator(1.1, damping_ratio);
    const CaseResult exact = result_of(model, {.integrator = ExactBetweenEvents{}});
    std::vector<double> errors;
    for (const double length : {160e-3, 80e-3, 40e-3}) {
      const CaseResult result = result_of(model, steps_of(length));
      EXPECT_NEAR(result.solver.longest_step, length, 1e-12);
      errors.push_back(std::abs(peak(result, "displacement") / peak(exact, "displacement") - 1.0));
    }
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_GT(order(errors[i - 1], errors[i]), 3.3) << i;
  }
}

TEST(StepsOverSamples, KeepTheToleranceByDefault) {
  for (const double period : {0.2, 0.5, 1.1, 2.5})
    for (const double damping_ratio : {0.0, 0.05, 0.3}) {
      SCOPED_TRACE(::testing::Message() << "period " << period << ", damping " << damping_ratio);
      const Model model = oscillator(period, damping_ratio);
      const CaseResult result = result_of(model, {}), exact = result_of(model, {.integrator = ExactBetweenEvents{}});
      for (const char* quantity : {"displacement", "velocity", "absolute_acceleration", "drift", "storey_shear"})
        EXPECT_NEAR(peak(result, quantity) / peak(exact, quantity), 1.0, 10.0 * TransientOptions{}.tolerance)
            << quantity;
      EXPECT_GE(result.solver.longest_step, 2.0 * interval);
      EXPECT_LT(std::abs(result.energy.equation_residual), 2e-4 * result.energy.largest_input);
    }
}

}  // namespace
}  // namespace moat
