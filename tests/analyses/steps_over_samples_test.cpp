// Steps of fourth order, and exact ones, that are longer than the interval of the motion's samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "analyses/case_run.hpp"
#include "analyses/error_bars.hpp"
#include "analysis_testing.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "peak_in.hpp"
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
    errors.push_back(std::abs(peak_in(result, "displacement").value / peak_in(exact, "displacement").value - 1.0));
  }
  // Steps are shorter where the displacement passes zero, so that the order of one halving scatters.
  EXPECT_GT(order(errors.front(), errors.back()) / static_cast<double>(errors.size() - 1), 3.3);
}

TEST(StepsOverSamples, KeepTheTolerance) {
  for (const double period : {0.2, 0.5, 1.1, 2.5}) {
    SCOPED_TRACE(period);
    const Model model = oscillator(period, 0.0);
    const CaseResult result = result_of(model, {.largest_step = 40 * ms}),
                     exact = result_of(model, {.integrator = ExactBetweenEvents{}});
    EXPECT_GE(result.solver.longest_step, 2.0 * interval);
    for (const char* quantity : {"displacement", "velocity", "absolute_acceleration", "drift", "storey_shear"})
      EXPECT_NEAR(peak_in(result, quantity).value / peak_in(exact, quantity).value, 1.0,
                  10.0 * TransientOptions{}.tolerance)
          << quantity;
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
                 exact =
                     compute_peaks(same, motion, {.integrator = ExactBetweenEvents{}, .largest_step = time_step * s})
                         .peaks;
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
  ASSERT_FALSE(fine.touches.empty());
  EXPECT_EQ(found.touches.size(), fine.touches.size());
  for (std::size_t i = 0; i < fine.peaks.size(); ++i)
    EXPECT_NEAR(found.peaks[i].value, fine.peaks[i].value, 2e-3 * std::abs(fine.peaks[i].value))
        << fine.peaks[i].quantity;
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

struct ExactRun {
  PeaksAndImpacts peaks;
  MotionState end;
};

ExactRun exact_run(const Model& model, TransientOptions options) {
  options.integrator = ExactBetweenEvents{};
  ExactRun run;
  Model copy = model;
  run.peaks = compute_peaks(copy, rough_motion(), options);
  run.end = copy.state();
  return run;
}

// The motion at the ends of steps is exact for any length.
TEST(ExactStepsOverSamples, EndWhereShorterOnesEnd) {
  const Model model = tower(0.0);
  const ExactRun fine = exact_run(model, {.largest_step = interval * s});
  EXPECT_DOUBLE_EQ(fine.peaks.solver.longest_step, interval);
  for (const double tolerance : {3e-5, 1e-3, 0.5}) {
    SCOPED_TRACE(tolerance);
    const ExactRun run = exact_run(model, {.tolerance = tolerance});
    EXPECT_GE(run.peaks.solver.longest_step, 2.0 * interval);
    for (Eigen::Index i = 0; i < fine.end.displacement.size(); ++i) {
      EXPECT_NEAR(run.end.displacement[i], fine.end.displacement[i], 1e-11);
      EXPECT_NEAR(run.end.velocity[i], fine.end.velocity[i], 1e-10);
      EXPECT_NEAR(run.end.acceleration[i], fine.end.acceleration[i], 1e-8);
    }
  }
}

TEST(ExactStepsOverSamples, FindPeaksToTheirTolerance) {
  for (const double clearance : {0.0, 0.04}) {
    SCOPED_TRACE(clearance);
    const Model model = tower(clearance);
    const ExactRun fine = exact_run(model, {.tolerance = 1e-7, .steps_per_contact = 1024, .largest_step = 0.1 * ms});
    long steps_before = std::numeric_limits<long>::max();
    for (const double tolerance : {1e-6, 3e-5, 1e-3}) {
      SCOPED_TRACE(tolerance);
      const ExactRun run = exact_run(model, {.tolerance = tolerance, .steps_per_contact = 256});
      EXPECT_LT(run.peaks.solver.accepted_steps, steps_before);
      steps_before = run.peaks.solver.accepted_steps;
      EXPECT_EQ(run.peaks.touches.size(), fine.peaks.touches.size());
      // In contact Newmark's steps have errors of their own.
      const double allowed = ExactSteps::cubics_within * tolerance + (clearance > 0.0 ? 2e-4 : 1e-6);
      for (std::size_t i = 0; i < fine.peaks.peaks.size(); ++i)
        EXPECT_NEAR(run.peaks.peaks[i].value / fine.peaks.peaks[i].value, 1.0, allowed)
            << fine.peaks.peaks[i].quantity << " " << fine.peaks.peaks[i].where;
    }
  }
}

// The largest velocity of a damped oscillator at rest under ground accelerations that are linear between samples, from
// the closed form over every interval, looked at 500 times in each.
double largest_velocity(double period, double damping_ratio, double time_step, const std::vector<double>& samples) {
  const double w = 2.0 * std::numbers::pi / period, decay = damping_ratio * w,
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
TEST(ExactStepsOverSamples, FindPeaksOfVelocityOfStiffBodies) {
  constexpr double long_interval = 20e-3, damping_ratio = 0.05;  // s, 1
  std::vector<double> samples;
  for (int i = 0; i <= 500; ++i) {
    const double t = long_interval * i;
    samples.push_back(2.0 * std::sin(0.3 * t) * std::sin(4.0 * t));
  }
  const GroundMotion motion{"growing", long_interval, samples};
  for (const double period : {0.005, 0.01, 0.02}) {
    SCOPED_TRACE(period);
    Model model = oscillator(period, damping_ratio);
    const auto peaks = compute_peaks(model, motion, {.integrator = ExactBetweenEvents{}}).peaks;
    const auto velocity = std::ranges::find(peaks, "velocity", &Peak::quantity);
    ASSERT_NE(velocity, peaks.end());
    EXPECT_NEAR(velocity->magnitude() / largest_velocity(period, damping_ratio, long_interval, samples), 1.0,
                ExactSteps::cubics_within * TransientOptions{}.tolerance);
  }
}

// The middle of three bodies that swing against each other stays at rest but for round-off.
TEST(ExactStepsOverSamples, AreNotShortenedByRoundOff) {
  const auto steps_of = [](double asymmetry) {
    const Mass mass = 1e4 / 3.0 * kg;
    const Speed speed = 0.3 * m / s;
    Model model;
    const NodeId left = add(model, Node{.name = "left", .mass = mass, .initial_velocity = -speed}),
                 middle = add(model, Node{.name = "middle", .mass = mass}),
                 right = add(model, Node{.name = "right", .mass = mass, .initial_velocity = (1.0 + asymmetry) * speed});
    const auto connect = [&](const char* name, NodeId lower, NodeId upper) {
      add(model, ShearSpring{.name = name, .lower = lower, .upper = upper, .stiffness = 7e4 * N / m});
    };
    connect("left to ground", ground, left);
    connect("left to middle", left, middle);
    connect("middle to right", middle, right);
    connect("right to ground", ground, right);
    Transient analysis{model, still_ground(20 * s), {.integrator = ExactBetweenEvents{}}};
    analysis.run();
    return analysis.statistics().accepted_steps;
  };
  // Where the middle moves, too, the model swings in more modes.
  EXPECT_LE(steps_of(0.0), steps_of(0.1));
}

// A pull to and fro at 20 Hz that begins at 3 s: the steps before are long, and those after must see it.
TEST(ExactStepsOverSamples, BecomeShorterWhereTheMotionNeedsIt) {
  std::vector<double> samples;
  for (int i = 0; i <= 1200; ++i) {
    const double t = interval * i;
    samples.push_back(std::sin(3.0 * t) + (t >= 3.0 ? 2.0 * std::sin(40.0 * std::numbers::pi * (t - 3.0)) : 0.0));
  }
  Model model = tower(0.0);
  Transient analysis{model, {"two parts", interval, samples}, {.integrator = ExactBetweenEvents{}}};
  long steps_before = 0;
  while (!analysis.finished()) {
    analysis.advance();
    if (model.state().time < 3.0) steps_before = analysis.statistics().accepted_steps;
  }
  EXPECT_GT(analysis.statistics().longest_step, 3.0 * interval);
  EXPECT_GT(analysis.statistics().repeated_steps, 0);
  // Both parts last 3 s. Steps in the second one are about half as long.
  EXPECT_GT(2 * (analysis.statistics().accepted_steps - steps_before), 3 * steps_before);
}

TEST(ExactStepsOverSamples, StateTheirLongestStep) {
  Model model = tower(0.0);
  Transient analysis{model, rough_motion(), {.integrator = ExactBetweenEvents{}}};
  EXPECT_NE(analysis.assumptions().front().find("at most 0.04 s"), std::string::npos) << analysis.assumptions().front();
}

// Rows lie inside such steps, too. Energies are linear there, between the ends of steps.
TEST(ExactStepsOverSamples, HaveAllRowsOfHistories) {
  const Model model = tower(0.04);
  const CaseResult at_ends = result_of(model, {.integrator = ExactBetweenEvents{}}),
                   inside = result_of(model, {.integrator = ExactBetweenEvents{}, .largest_step = 40 * ms});
  EXPECT_DOUBLE_EQ(at_ends.solver.longest_step, interval);
  EXPECT_GE(inside.solver.longest_step, 2.0 * interval);
  ASSERT_EQ(inside.histories.rows(), at_ends.histories.rows());
  for (const auto& [quantity, allowed] :
       {std::pair{"time", 1e-12}, {"displacement", 1e-3}, {"absolute_acceleration", 1e-3}, {"input_energy", 2e-3}}) {
    const std::vector<double>&expected = column(at_ends, quantity), &found = column(inside, quantity);
    double largest = 0.0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(found[i], expected[i], allowed * largest) << quantity << " " << i;
  }
}

// A step that ends at a change is at its margin there: this is no reason to repeat it.
TEST(ExactStepsOverSamples, AreSeldomRepeatedForChanges) {
  Model model = tower(0.04);
  const PeaksAndImpacts run =
      compute_peaks(model, rough_motion(), {.integrator = ExactBetweenEvents{}, .tolerance = 3e-4});
  ASSERT_GT(run.touches.size(), 10u);
  EXPECT_GE(run.solver.longest_step, 4.0 * interval);
  EXPECT_LT(run.solver.repeated_steps, static_cast<long>(run.touches.size()));
}

// A body on a bearing whose yield is located, on ground that sways slowly.
class SlowGround : public ::testing::Test {
 protected:
  SlowGround() {
    std::vector<double> samples;
    for (int i = 0; i <= 4000; ++i) samples.push_back(2.0 * std::sin(2.0 * i * sample));
    motion.emplace("slow", sample, samples);
    const NodeId body = add(model, Node{.name = "body", .mass = 1e5 * kg});
    add(model,
        LeadRubberBearing{
            .upper = body, .yield_force = 40 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0.4 * MN / m});
  }

  // Calls look(length of a step, number of changes before it) for every step.
  int run(const std::function<void(double, int)>& look) {
    Transient analysis{
        model, *motion, {.integrator = ExactBetweenEvents{}, .tolerance = 3e-4, .largest_step = longest * s}};
    double last = 0.0;
    testing::Watch watch{[&](const StepView& view) {
      const double now = view.model.state().time;
      if (now > last) look(now - last, watch.events);
      last = now;
    }};
    analysis.attach(watch);
    analysis.run();
    return watch.events;
  }

  static constexpr double sample = 5e-3, longest = 40e-3;  // s
  std::optional<GroundMotion> motion;
  Model model;
};

TEST_F(SlowGround, StepsAreSoonAsLongAsBeforeAChange) {
  int changes = 0, steps = 0, most = 0;
  const int all = run([&](double length, int before) {
    if (before > changes) steps = 0;
    changes = before;
    if (length > 0.99 * longest) steps = std::numeric_limits<int>::min();
    if (before > 0) most = std::max(most, ++steps);
  });
  EXPECT_GT(all, 10);
  // To the next sample, then to multiples of at most eight samples.
  EXPECT_LE(most, 3);
}

// A bearing that has just turned is at its margin. One that has just yielded is not: it slides until it turns.
TEST_F(SlowGround, StepsNeedNotEndAtTheNextSampleBehindAYield) {
  int changes = 0, over_samples = 0;
  const int all = run([&](double length, int before) {
    if (before > changes && length > 1.01 * sample) ++over_samples;
    changes = before;
  });
  // Every second change is a yield.
  EXPECT_GT(over_samples, all / 4);
  EXPECT_LE(over_samples, (all + 1) / 2);
}

TEST(ExactStepsOverSamples, BalanceTheirEnergy) {
  for (const double clearance : {0.0, 0.04}) {
    Model model = tower(clearance);
    const CaseResult result = run_case(model, rough_motion(),
                                       {.transient = {.integrator = ExactBetweenEvents{}, .largest_step = 40 * ms},
                                        .history_interval = 40 * ms,
                                        .error_bars = ErrorBarMode::never});
    EXPECT_GE(result.solver.longest_step, 2.0 * interval);
    EXPECT_LT(std::abs(result.energy.equation_residual), 2e-4 * result.energy.largest_input);
  }
}

}  // namespace
}  // namespace moat
