// Steps of fourth order that are longer than the interval of the motion's samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analyses/case_run.hpp"
#include "analyses/error_bars.hpp"
#include "analysis_testing.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "structures/moat.hpp"

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
  for (const double length : {10e-3, 20e-3, 40e-3}) {
    SCOPED_TRACE(length);
    const CaseResult result = result_of(oscillator(1e6, 0.0), steps_of(length));
    EXPECT_NEAR(result.solver.longest_step, length, 1e-12);
    EXPECT_LT(result.solver.accepted_steps, 0.8 * 10.0 / interval);
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
  const Model model = oscillator(1.1, 0.0);
  const CaseResult exact = result_of(model, {.integrator = ExactBetweenEvents{}});
  std::vector<double> errors;
  for (const double length : {40e-3, 20e-3, 10e-3}) {
    const CaseResult result = result_of(model, steps_of(length));
    EXPECT_NEAR(result.solver.longest_step, length, 1e-12);
    errors.push_back(std::abs(peak(result, "displacement") / peak(exact, "displacement") - 1.0));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_GT(order(errors[i - 1], errors[i]), 3.3) << i;
}

TEST(StepsOverSamples, KeepTheTolerance) {
  for (const double period : {0.2, 0.5, 1.1, 2.5}) {
    SCOPED_TRACE(period);
    const Model model = oscillator(period, 0.0);
    const CaseResult result = result_of(model, {.largest_step = 40 * ms}),
                     exact = result_of(model, {.integrator = ExactBetweenEvents{}});
    EXPECT_GE(result.solver.longest_step, 2.0 * interval);
    for (const char* quantity : {"displacement", "velocity", "absolute_acceleration", "drift", "storey_shear"})
      EXPECT_NEAR(peak(result, quantity) / peak(exact, quantity), 1.0, 10.0 * TransientOptions{}.tolerance) << quantity;
    EXPECT_LT(std::abs(result.energy.equation_residual), 2e-4 * result.energy.largest_input);
  }
}

// A damper's force follows the velocity of the ground, which is not smooth inside such a step.
TEST(StepsOverSamples, AreNotTakenWithDampersToTheGround) {
  EXPECT_DOUBLE_EQ(result_of(oscillator(1.1, 0.05), {.largest_step = 40 * ms}).solver.longest_step, interval);
}

// Energies are known at the ends of steps alone.
TEST(StepsOverSamples, AreNotTakenWhereHistoriesNeedARow) {
  EXPECT_DOUBLE_EQ(result_of(oscillator(1.1, 0.0), {}).solver.longest_step, interval);
}

GroundMotion noise(double time_step, std::size_t count) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i);
    samples[i] = 2.0 * std::sin(1234.5 * x * x + 0.3 * x);
  }
  return {"noise", time_step, samples};
}

// Turns of the velocity lie at any sample. A cubic over the step sees one at most.
TEST(StepsOverSamples, FindPeaksOfVelocityAtTheSamplesInside) {
  for (const double time_step : {2.5e-3, 5e-3, 10e-3})
    for (const double period : {4.0, 8.0, 20.0}) {
      SCOPED_TRACE(::testing::Message() << "samples " << time_step << ", period " << period);
      const GroundMotion motion = noise(time_step, 4001);
      Model model = oscillator(period, 0.0), same = model;
      const auto found = compute_peaks(model, motion, {}).peaks,
                 exact = compute_peaks(same, motion, {.integrator = ExactBetweenEvents{}}).peaks;
      ASSERT_EQ(found.size(), exact.size());
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(found[i].value / exact[i].value, 1.0, 1e-3) << exact[i].quantity;
    }
}

// The ground moves 2 mm to and fro between two long steps' ends, at which it stands still.
TEST(StepsOverSamples, DoNotHideATouchInside) {
  std::vector<double> samples(301);
  samples[101] = samples[103] = -5.0;
  samples[102] = 10.0;
  const GroundMotion motion{"jolt", 0.01, samples};
  const auto peaks_with = [&](Time largest_step) {
    Model model = oscillator(30.0, 0.0);
    add(model, Moat{.around = NodeId{0},
                    .clearance = 0.1 * mm,
                    .law = HertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65}});
    return compute_peaks(model, motion, {.largest_step = largest_step});
  };
  const PeaksAndImpacts found = peaks_with({}), fine = peaks_with(1 * ms);
  ASSERT_GT(fine.impacts, 0u);
  EXPECT_EQ(found.impacts, fine.impacts);
  for (std::size_t i = 0; i < fine.peaks.size(); ++i)
    EXPECT_NEAR(found.peaks[i].value, fine.peaks[i].value, 2e-3 * std::abs(fine.peaks[i].value))
        << fine.peaks[i].quantity;
}

}  // namespace
}  // namespace moat
