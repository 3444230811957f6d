// Peaks inside exact steps, and inside those of fourth order beside them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyses/integrators/exact_method.hpp"
#include "analysis_testing.hpp"
#include "moat.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double interval = 5e-3;  // s

// Three sines, the fastest of 14 Hz, with a noise of 2 % from sample to sample.
GroundMotion rough_motion() {
  return sampled("rough", 10 * s, interval * s, [](double t) {
    const double i = std::round(t / interval);
    return 2.0 * std::sin(5.0 * t) + 0.7 * std::sin(31.0 * t + 1.0) + 0.3 * std::sin(88.0 * t) +
           0.06 * std::sin(1234.5 * i * i);
  });
}

CaseResult result_of(const Model& model, const TransientOptions& options) {
  return run_case(model, rough_motion(),
                  {.transient = options, .history_interval = interval * s, .error_bars = ErrorBarMode::never});
}

TEST(StepsOfFourthOrder, HaveThePeaksOfExactOnes) {
  for (const double period : {0.2, 0.5, 1.1, 2.5}) {
    SCOPED_TRACE(period);
    const Model model = oscillator({.frequency = 2.0 * pi / period});
    const CaseResult result = result_of(model, {}), exact = result_of(model, {.integrator = ExactBetweenEvents{}});
    for (const char* quantity : {"displacement", "velocity", "absolute_acceleration", "drift", "storey_shear"})
      EXPECT_NEAR(peak_in(result, quantity).value / peak_in(exact, quantity).value, 1.0,
                  10.0 * TransientOptions{}.tolerance)
          << quantity;
    EXPECT_LT(std::abs(result.energy.equation_residual), 2e-4 * result.energy.largest_input);
  }
}

// Three bodies on a soft bearing; the fastest vibration has a period of 0.1 s.
Model tower(double clearance) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 2e4 * kg}),
               floor = add(model, Node{.name = "floor", .mass = 1e4 * kg}),
               roof = add(model, Node{.name = "roof", .mass = 5e3 * kg});
  add(model, ShearSpring{.name = "bearing", .lower = ground, .upper = base, .stiffness = 2e5 * N / m});
  add(model, ShearSpring{.name = "first", .lower = base, .upper = floor, .stiffness = 1e7 * N / m});
  add(model, ShearSpring{.name = "second", .lower = floor, .upper = roof, .stiffness = 6e6 * N / m});
  add(model, ViscousDamper{.name = "damper", .lower = base, .upper = roof, .damping = 1e4 * N * s / m});
  if (clearance > 0.0)
    add(model, Moat{.around = base,
                    .clearance = clearance * m,
                    .law = HertzDamp{.stiffness = 2.95e8 * N / m_3_2, .restitution = 0.65}});
  return model;
}

PeaksAndImpacts exact_run(const Model& model, TransientOptions options) {
  options.integrator = ExactBetweenEvents{};
  return compute_peaks(model, rough_motion(), options);
}

TEST(ExactSteps, FindPeaksToTheirTolerance) {
  for (const double clearance : {0.0, 0.04}) {
    SCOPED_TRACE(clearance);
    const Model model = tower(clearance);
    const PeaksAndImpacts fine =
        exact_run(model, {.tolerance = 1e-7, .steps_per_contact = 1024, .largest_step = 0.1 * ms});
    long steps_before = std::numeric_limits<long>::max();
    for (const double tolerance : {1e-6, 3e-5, 1e-3}) {
      SCOPED_TRACE(tolerance);
      const PeaksAndImpacts run = exact_run(model, {.tolerance = tolerance, .steps_per_contact = 256});
      EXPECT_LE(run.solver.accepted_steps, steps_before);
      steps_before = run.solver.accepted_steps;
      EXPECT_EQ(run.touches.size(), fine.touches.size());
      // In contact Newmark's steps have errors of their own.
      const double allowed = ExactMethod::cubics_within * tolerance + (clearance > 0.0 ? 2e-4 : 1e-6);
      for (std::size_t i = 0; i < fine.peaks.size(); ++i)
        EXPECT_NEAR(run.peaks[i].value / fine.peaks[i].value, 1.0, allowed)
            << fine.peaks[i].quantity << " " << fine.peaks[i].where;
    }
  }
}

// The largest velocity of a damped oscillator at rest under ground accelerations that are linear between samples, from
// the closed form over every interval, looked at 500 times in each.
double largest_velocity(double period, double damping_ratio, const GroundMotion& motion) {
  const auto samples = motion.samples();
  const double time_step = motion.time_step();
  const double w = 2.0 * pi / period, decay = damping_ratio * w,
               damped = w * std::sqrt(1.0 - damping_ratio * damping_ratio);
  double u = 0.0, v = 0.0, largest = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    // u = offset + rise t + exp(-decay t) (c cos(damped t) + d sin(damped t))
    const double slope = (samples[i + 1] - samples[i]) / time_step, rise = -slope / (w * w),
                 offset = -samples[i] / (w * w) - 2.0 * damping_ratio / w * rise;
    const double c = u - offset, d = (v - rise + decay * c) / damped;
    constexpr int looks = 500;
    for (int look = 1; look <= looks; ++look) {
      const double t = time_step * look / looks, left = std::exp(-decay * t), cosine = std::cos(damped * t),
                   sine = std::sin(damped * t);
      u = offset + rise * t + left * (c * cosine + d * sine);
      v = rise + left * ((damped * d - decay * c) * cosine - (damped * c + decay * d) * sine);
      largest = std::max(largest, std::abs(v));
    }
  }
  return largest;
}

// A stiff body follows the ground: its absolute acceleration is as smooth as that of the ground, its velocity follows
// the slope between samples.
TEST(ExactSteps, FindPeaksOfVelocityOfStiffBodies) {
  constexpr double long_interval = 20e-3, damping_ratio = 0.05;  // s, 1
  const GroundMotion motion = sampled("growing", 10 * s, long_interval * s,
                                      [](double t) { return 2.0 * std::sin(0.3 * t) * std::sin(4.0 * t); });
  for (const double period : {0.005, 0.01, 0.02}) {
    SCOPED_TRACE(period);
    Model model = oscillator({.frequency = 2.0 * pi / period, .damping_ratio = damping_ratio});
    const auto peaks = compute_peaks(model, motion, {.integrator = ExactBetweenEvents{}}).peaks;
    const auto velocity = std::ranges::find(peaks, "velocity", &Peak::quantity);
    ASSERT_NE(velocity, peaks.end());
    EXPECT_NEAR(velocity->magnitude() / largest_velocity(period, damping_ratio, motion), 1.0,
                ExactMethod::cubics_within * TransientOptions{}.tolerance);
  }
}

}  // namespace
}  // namespace moat
