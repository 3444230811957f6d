// Errors of peaks: closed forms lie within them, and a case that finer steps change is called unsettled.

#include "moat.hpp"
#include "peak_in.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "analysis_testing.hpp"
#include "unlocated_bilinear.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;
using testing::constant_acceleration;
using testing::still_ground;

// --- Options of the companion

TEST(CompanionOptions, AFixedStepIsHalved) {
  const TransientOptions companion = companion_options({.step = 4 * ms, .end = 3 * s}, 0.004);
  EXPECT_EQ(companion.step.si(), 0.002);
  EXPECT_EQ(companion.end.si(), 3.0);
  EXPECT_EQ(companion_description(companion), "The same case with a fixed step of 0.002 s.");
}

TEST(CompanionOptions, AnAdaptedStepIsFinerInEveryRespect) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    const TransientOptions companion =
        companion_options({.integrator = integrator, .tolerance = 1.6e-4, .steps_per_contact = 48}, 0.01);
    EXPECT_EQ(companion.integrator, integrator);
    EXPECT_EQ(companion.step.si(), 0.0);
    EXPECT_NEAR(companion.tolerance, 1e-5, 1e-20);
    EXPECT_EQ(companion.steps_per_contact, 96);
    EXPECT_EQ(companion.largest_step.si(), 0.005);
    EXPECT_EQ(companion_description(companion),
              "The same case with a tolerance of 1e-05, 96 steps per contact and steps of at most 0.005 s.");
  }
}

TEST(CompanionOptions, ATighterToleranceThanIsAllowedIsNotAskedFor) {
  EXPECT_EQ(companion_options({.tolerance = 1e-12}, 0.01).tolerance, 1e-12);
}

TEST(LongestStep, IsTheIntervalDividedByAPowerOfTwo) {
  for (const auto& [largest, longest] : {std::pair{0.0, 0.01},
                                         {1.0, 0.01},
                                         {0.01, 0.01},
                                         {0.009, 0.005},
                                         {0.01 / 3.0, 0.0025},
                                         {1e-300, 0x1p-40 * 0.01}})
    EXPECT_EQ(longest_step({.largest_step = largest * s}, 0.01), longest) << largest;
}

TEST(LongestStep, IsNotExceeded) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    Model model = testing::oscillator({.frequency = 1.0});
    Transient analysis{model, constant_acceleration(1.0, 1 * s), {.integrator = integrator, .largest_step = 3 * ms}};
    analysis.run();
    EXPECT_EQ(analysis.statistics().longest_step, 0.0025);
  }
}

// --- Closed forms

// A damped oscillator under a constant acceleration of the ground.
struct Oscillator {
  static constexpr double mass = 1000.0, frequency = 2.0 * pi, ratio = 0.05, pull = 2.0;  // kg, 1/s, 1, m/s^2

  // Overshoot of the static displacement.
  static double peak_displacement() {
    return pull / (frequency * frequency) * (1.0 + std::exp(-pi * ratio / std::sqrt(1.0 - ratio * ratio)));
  }
  static double peak_velocity() {
    const double root = std::sqrt(1.0 - ratio * ratio);
    return pull / frequency * std::exp(-ratio / root * std::acos(ratio));
  }
  static Model model() { return testing::oscillator({.mass = mass, .frequency = frequency, .damping_ratio = ratio}); }
  static CaseResult run(const TransientOptions& options) {
    Model oscillator = model();
    return run_case(oscillator, constant_acceleration(pull, 4 * s, 20 * ms),
                    {.transient = options, .error_bars = ErrorBarMode::always});
  }
};

void expect_within_bar(const CaseResult& result, std::string_view quantity, double exact, double largest_share) {
  const Peak peak = testing::peak_in(result, quantity);
  EXPECT_LE(std::abs(peak.magnitude() - exact), peak.error)
      << quantity << ": " << peak.value << " instead of " << exact;
  EXPECT_LE(peak.error, largest_share * exact) << quantity << ": a bar this wide says nothing";
}

TEST(ErrorBars, HoldAnOscillatorWithCoarseFixedSteps) {
  // Newmark's period is longer by (w h)^2 / 12, which is 0.13 % with the first step; with each the damping takes more.
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    SCOPED_TRACE(step);
    const CaseResult result = Oscillator::run({.step = step * s});
    const double phase = std::pow(Oscillator::frequency * step, 2) / 12.0;
    expect_within_bar(result, "displacement", Oscillator::peak_displacement(), 4.0 * phase);
    expect_within_bar(result, "velocity", Oscillator::peak_velocity(), 4.0 * phase);
    EXPECT_TRUE(result.error_bars.checked);
    EXPECT_FALSE(result.error_bars.unsettled) << result.error_bars.reason;
    EXPECT_TRUE(result.error_bars.unsettled_peaks.empty());
  }
}

TEST(ErrorBars, HoldAnOscillatorWithAdaptedAndExactSteps) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
      SCOPED_TRACE(tolerance);
      const CaseResult result = Oscillator::run({.integrator = integrator, .tolerance = tolerance});
      expect_within_bar(result, "displacement", Oscillator::peak_displacement(), 1e-2);
      expect_within_bar(result, "velocity", Oscillator::peak_velocity(), 1e-2);
      EXPECT_FALSE(result.error_bars.unsettled) << result.error_bars.reason;
    }
  }
}

TEST(ErrorBars, HoldTheForceAndIndentationOfAnElasticImpact) {
  constexpr double mass = 1000.0, stiffness = 4e7, speed = 0.5;  // the contact lasts pi sqrt(m/k) = 16 ms
  for (const int steps : {8, 32, 128}) {
    SCOPED_TRACE(steps);
    Model model = testing::body_before_wall(LinearElastic{.stiffness = stiffness * N / m}, mass, speed, 0.0123);
    const CaseResult result = run_case(model, still_ground(0.1 * s),
                                       {.transient = {.steps_per_contact = steps}, .error_bars = ErrorBarMode::always});
    expect_within_bar(result, "impact_force", speed * std::sqrt(stiffness * mass), 0.1);
    expect_within_bar(result, "indentation", speed * std::sqrt(mass / stiffness), 0.1);
    EXPECT_EQ(result.impacts.size(), 1u);
    EXPECT_EQ(result.error_bars.companion_impacts, 1u);
  }
}

TEST(ErrorBars, AreUnsettledWhereTheStepIsFarTooLong) {
  const CaseResult result = Oscillator::run({.step = 200 * ms});  // five to a period
  EXPECT_TRUE(result.error_bars.unsettled);
  ASSERT_FALSE(result.error_bars.unsettled_peaks.empty());
  const Peak& worst = result.error_bars.unsettled_peaks.front();
  EXPECT_GT(worst.error, 0.01 * worst.value);
  for (const Peak& peak : result.error_bars.unsettled_peaks)
    EXPECT_LE(peak.error / peak.magnitude(), worst.error / worst.magnitude());
  const std::string warning = result.warnings.back();
  EXPECT_TRUE(warning.starts_with("The case is not settled: ")) << warning;
  EXPECT_NE(warning.find(worst.where), std::string::npos) << warning;
  EXPECT_TRUE(warning.ends_with("Take a shorter step (now 0.2 s).")) << warning;
  expect_within_bar(result, "displacement", Oscillator::peak_displacement(), 1.0);
}

// --- Unsettled cases

// The oscillator with a wall between the peaks of a run with this step and of its companion: one of them touches.
TEST(ErrorBars, AGrazingContactIsUnsettled) {
  const GroundMotion motion = constant_acceleration(Oscillator::pull, 4 * s, 20 * ms);
  const TransientOptions options{.step = 20 * ms};
  const auto peak_with = [&](const TransientOptions& each) {
    Model free = Oscillator::model();
    return compute_peaks(free, motion, each).peaks.front().magnitude();
  };
  const double coarse = peak_with(options), fine = peak_with(companion_options(options, 0.02));
  ASSERT_GT(std::abs(coarse - fine), 1e-6 * fine);

  Model model = Oscillator::model();
  // The pull is to the left.
  add(model, Gap<LinearElastic>{.name = "wall",
                                .left = ground,
                                .right = NodeId{0},
                                .clearance = 0.5 * (coarse + fine) * m,
                                .law = {.stiffness = 1e6 * N / m}});
  const CaseResult result = run_case(model, motion, {.transient = options, .error_bars = ErrorBarMode::always});
  const ErrorBars& bars = result.error_bars;
  EXPECT_EQ(result.impacts.size() + bars.companion_impacts, 1u);
  EXPECT_TRUE(bars.unsettled);
  EXPECT_NE(bars.reason.find(result.impacts.empty() ? "has 1 impact instead of 0" : "has 0 impacts instead of 1"),
            std::string::npos)
      << bars.reason;
  const auto unsettled = std::ranges::find(bars.unsettled_peaks, "impact_force", &Peak::quantity);
  ASSERT_NE(unsettled, bars.unsettled_peaks.end()) << "one run has a force and the other has none";
  EXPECT_EQ(unsettled->where, "wall");
  EXPECT_NE(result.warnings.back().find("Impacts amplify every small difference"), std::string::npos);
}

// --- The estimate alone

// So many impacts, one a second, each with 1 m/s.
std::vector<Impact> touches(int count) {
  std::vector<Impact> list;
  for (int i = 0; i < count; ++i) list.push_back({.where = "wall", .start = 1.0 * i, .approach_speed = 1.0});
  return list;
}

// A peak, and the same of the companion; none for a quantity that the companion lacks.
struct Pair {
  std::string quantity;
  double value;
  std::optional<double> finer;
};
struct Estimate {
  ErrorBars bars;
  std::vector<Peak> peaks;
};
Estimate estimate(const std::vector<Pair>& pairs, const std::vector<Impact>& impacts = {},
                  const std::vector<Impact>& finer_impacts = {}, double least_share = 0.0) {
  Estimate made;
  PeaksAndImpacts companion{{}, finer_impacts, {}};
  for (const auto& [quantity, value, finer] : pairs) {
    made.peaks.push_back({quantity, "here", value, "m", 1.0});
    if (finer) companion.peaks.push_back({quantity, "here", *finer, "m", 1.0});
  }
  made.bars = estimate_errors(made.peaks, impacts, companion, least_share);
  return made;
}

TEST(EstimateErrors, IsAtLeastRichardsons) {
  const auto [bars, peaks] =
      estimate({{"displacement", 100.0, 100.03}, {"drift", 10.0, 9.997}}, touches(3), touches(3));
  EXPECT_GE(peaks[0].error, 4.0 / 3.0 * 0.03);
  EXPECT_LE(peaks[0].error, 10.0 * 0.03);
  EXPECT_NEAR(peaks[1].error, 0.1 * peaks[0].error, 1e-4 * peaks[1].error);
  EXPECT_TRUE(bars.checked);
  EXPECT_FALSE(bars.unsettled);
  EXPECT_EQ(bars.reason, "");
}

TEST(EstimateErrors, DoesNotTrustAgreementByAccident) {
  const std::vector<Peak> peaks = estimate({{"a", 100.0, 100.0}, {"b", 100.0, 100.2}, {"c", 100.0, 100.3}}).peaks;
  EXPECT_GT(peaks[0].error, 0.02);
  EXPECT_LT(peaks[0].error, peaks[1].error);
}

// A force is the only peak of its unit.
TEST(EstimateErrors, DoesNotTrustAgreementOfOneUnit) {
  const auto run = [](double a, double b) {
    return std::vector<Peak>{{"a", "here", a, "m", 1.0}, {"b", "here", b, "m", 1.0}, {"force", "here", 10.0, "N", 1.0}};
  };
  std::vector<Peak> peaks = run(100.0, 100.0);
  estimate_errors(peaks, {}, {run(100.2, 100.3), {}, {}}, 0.0);
  EXPECT_GT(peaks[2].error, 0.001 * 10.0);
}

TEST(EstimateErrors, IsAtLeastTheShareThatTheRunPromises) {
  const std::vector<Peak> peaks = estimate({{"displacement", 100.0, 100.0}, {"drift", 0.0, 0.0}}, {}, {}, 1e-4).peaks;
  EXPECT_NEAR(peaks[0].error, 0.01, 1e-5);
  EXPECT_EQ(peaks[1].error, 0.0);
}

TEST(EstimateErrors, PromisesNoMoreThanTheToleranceWhereBendsAreNotLocated) {
  const auto least_share = [](bool located, const TransientOptions& options) {
    Model model = Oscillator::model();
    if (located)
      add(model, LeadRubberBearing{.upper = NodeId{0},
                                   .yield_force = 1 * kN,
                                   .yield_displacement = 1 * cm,
                                   .post_yield_stiffness = 10 * kN / m});
    else
      add(model, Isolator<testing::UnlocatedBilinear>{.upper = NodeId{0}, .law = {1e3, 0.01, 1e4}});
    return least_share_of_errors(model, options);
  };
  EXPECT_EQ(least_share(false, {.tolerance = 4e-5}), 1e-5);
  EXPECT_EQ(least_share(true, {.tolerance = 4e-5}), 0.0);
  EXPECT_EQ(least_share(false, {.step = 1 * ms}), 0.0) << "a fixed step has no tolerance";
  EXPECT_EQ(least_share_of_errors(Oscillator::model(), {}), 0.0);
}

TEST(EstimateErrors, OfAClearanceAreSharesOfTheApproach) {
  PeaksAndImpacts main;
  main.clearances = {{.where = "gap", .clearance = 0.2, .left = 0.05}};
  const PeaksAndImpacts companion = main;
  estimate_clearance_errors(main, companion, 1e-3);
  EXPECT_NEAR(main.clearances[0].error, 1e-3 * (0.2 - 0.05), 1e-8);
}

TEST(EstimateErrors, LeavesNoErrorToAForceThatNeitherRunHas) {
  const auto [bars, peaks] = estimate({{"displacement", 1.0, 1.001}, {"indentation", 0.0, 0.0}});
  EXPECT_EQ(peaks[1].error, 0.0);
  EXPECT_FALSE(bars.unsettled);
}

// A body that does not move but for round-off, and surfaces of a pendulum that never slide. A slip of a micrometre is a
// motion.
TEST(EstimateErrors, DoesNotCallRoundOffUnsettled) {
  EXPECT_FALSE(estimate({{"displacement", 1.0, 1.0001}, {"displacement", 3e-17, 7e-17}}).bars.unsettled);
  EXPECT_FALSE(estimate({{"displacement", 0.2, 0.2001}, {"third_surface_slip", 1.6e-19, -7e-20}}).bars.unsettled);
  EXPECT_TRUE(estimate({{"displacement", 0.2, 0.2001}, {"third_surface_slip", 1e-6, 1.1e-6}}).bars.unsettled);
}

TEST(EstimateErrors, OtherImpactsAreUnsettledEvenIfThePeaksAgree) {
  const Estimate same = estimate({{"displacement", 1.0, 1.0001}}, touches(7), touches(7)),
                 other = estimate({{"displacement", 1.0, 1.0001}}, touches(7), touches(8));
  EXPECT_FALSE(same.bars.unsettled);
  EXPECT_TRUE(other.bars.unsettled);
  EXPECT_EQ(other.bars.reason,
            "with finer steps it has 8 impacts instead of 7; all peaks are known to 1 % nevertheless");
  EXPECT_GT(other.peaks[0].error, same.peaks[0].error) << "the difference of two motions is no measure of an error";
}

// Two runs of a chaotic case have equally many impacts and, by chance, the same peaks, but their impacts part.
TEST(EstimateErrors, ImpactsThatPartAreUnsettledEvenIfThePeaksAgree) {
  std::vector<Impact> finer = touches(7);
  finer[5].approach_speed = 0.991;
  const Estimate close = estimate({{"displacement", 1.0, 1.0001}}, touches(7), finer);
  EXPECT_FALSE(close.bars.unsettled);
  finer[5].approach_speed = 0.989;
  const Estimate far = estimate({{"displacement", 1.0, 1.0001}}, touches(7), finer);
  EXPECT_TRUE(far.bars.unsettled);
  EXPECT_EQ(far.bars.reason,
            "from t = 5.00 s on, impacts with finer steps have other speeds, by more than 1 % of the fastest, so that "
            "bars of later peaks may be too small");
  EXPECT_GT(far.peaks[0].error, close.peaks[0].error);
}

// The same impacts, but those of two gaps at one instant are listed in the other order.
TEST(EstimateErrors, ComparesImpactsGapByGap) {
  const Impact left{.where = "left", .start = 1.0, .approach_speed = 0.5},
      right{.where = "right", .start = 1.0, .approach_speed = 0.9};
  EXPECT_FALSE(estimate({{"displacement", 1.0, 1.0001}}, {left, right}, {right, left}).bars.unsettled);
}

TEST(EstimateErrors, NamesTheWorstPeaksFirst) {
  std::vector<Peak> peaks, companion;
  for (const double share : {0.01, 0.02, 0.03, 0.04, 2.0, 1e-5}) {
    peaks.push_back({"drift", "storey " + std::to_string(peaks.size() + 1), 10.0, "m", 1.0});
    companion.push_back(peaks.back());
    companion.back().value *= 1.0 + share;
  }
  const ErrorBars bars = estimate_errors(peaks, touches(2), {companion, touches(2), {}});
  ASSERT_EQ(bars.unsettled_peaks.size(), 6u) << "the last is judged by a share of the median of all";
  EXPECT_EQ(bars.unsettled_peaks[0].where, "storey 5");
  EXPECT_EQ(bars.unsettled_peaks[1].where, "storey 4");
  EXPECT_TRUE(
      bars.reason.starts_with("6 of 6 peaks are not settled, with an error above 1 %: drift of \"storey 5\" (more "
                              "than 100 %), drift of \"storey 4\" ("))
      << bars.reason;
  EXPECT_TRUE(bars.reason.ends_with(" and 2 more")) << bars.reason;
}

TEST(EstimateErrors, DoesNotKnowTheErrorOfAPeakThatIsMissingOrNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto [bars, peaks] = estimate({{"a", 1.0, 1.0}, {"b", 1.0, nan}, {"c", nan, 1.0}, {"d", 1.0, {}}});
  EXPECT_TRUE(std::isfinite(peaks[0].error));
  for (const std::size_t i : {1u, 2u, 3u}) EXPECT_TRUE(std::isnan(peaks[i].error)) << i;
  EXPECT_EQ(bars.unsettled_peaks.size(), 3u);
  EXPECT_TRUE(bars.unsettled);
}

// --- When there is a companion

TEST(ErrorBarMode, TheCompanionChangesNothingElse) {
  const auto run = [](ErrorBarMode mode) {
    Model model = Oscillator::model();
    return run_case(model, constant_acceleration(1.0, 2 * s), {.error_bars = mode});
  };
  const CaseResult without = run(ErrorBarMode::never), with = run(ErrorBarMode::always);
  EXPECT_FALSE(without.error_bars.checked);
  EXPECT_TRUE(with.error_bars.checked);
  ASSERT_EQ(without.peaks.size(), with.peaks.size());
  for (std::size_t i = 0; i < with.peaks.size(); ++i) {
    EXPECT_EQ(without.peaks[i].value, with.peaks[i].value);
    EXPECT_TRUE(std::isnan(without.peaks[i].error));
    EXPECT_GE(with.peaks[i].error, 0.0);
  }
  EXPECT_EQ(without.solver.accepted_steps, with.solver.accepted_steps);
  EXPECT_EQ(without.solver.newton_iterations, with.solver.newton_iterations);
  EXPECT_GT(with.error_bars.companion_solver.accepted_steps, with.solver.accepted_steps);
}

TEST(ErrorBarMode, AutomaticLeavesOutALongRunAndSaysSo) {
  const auto run = [](Time duration, ErrorBarMode mode) {
    Model model = Oscillator::model();
    return run_case(model, constant_acceleration(1.0, duration), {.error_bars = mode}).error_bars;
  };
  EXPECT_TRUE(run(2 * s, ErrorBarMode::automatic).checked);
  // 2e5 steps evaluate more elements than a run with a companion may.
  const ErrorBars left_out = run(2000 * s, ErrorBarMode::automatic);
  EXPECT_FALSE(left_out.checked);
  EXPECT_NE(left_out.companion.find("--check"), std::string::npos) << left_out.companion;
  EXPECT_TRUE(run(2000 * s, ErrorBarMode::always).checked);
}

// Fails when it was evaluated too often: in the second of two runs.
struct Worn {
  int* uses;
  int most_uses;

  using State = NoState;

  Response evaluate(const State&, double deformation, double, State&) const {
    const double stiffness = ++*uses > most_uses ? std::numeric_limits<double>::quiet_NaN() : 1000.0;
    return {stiffness * deformation, stiffness, 0.0};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return 1000.0; }
};

CaseResult run_worn(int& uses, int most_uses, ErrorBarMode mode) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 10 * kg, .initial_velocity = 1 * m / s});
  add(model,
      Spring<Worn>{.name = "spring", .lower = ground, .upper = body, .law = {.uses = &uses, .most_uses = most_uses}});
  return run_case(model, still_ground(1 * s), {.error_bars = mode});
}

TEST(ErrorBarMode, ACompanionThatFailsCostsNothingButTheBars) {
  int uses = 0;
  const CaseResult whole = run_worn(uses, std::numeric_limits<int>::max(), ErrorBarMode::never);
  const int needed = uses;
  uses = 0;
  const CaseResult result = run_worn(uses, needed + 10, ErrorBarMode::always);
  EXPECT_FALSE(result.error_bars.checked);
  EXPECT_EQ(result.error_bars.companion, "No error bars: the second run failed.");
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_TRUE(result.warnings.back().starts_with(
      "There are no error bars, because the second run with finer steps failed: The step from t = "))
      << result.warnings.back();
  ASSERT_EQ(result.peaks.size(), whole.peaks.size());
  EXPECT_EQ(result.peaks[0].value, whole.peaks[0].value);
  EXPECT_TRUE(std::isnan(result.peaks[0].error));
}

TEST(ErrorBarMode, AFailedRunHasNoCompanion) {
  int uses = 0;
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 10 * kg, .initial_velocity = 1 * m / s});
  add(model, Spring<Worn>{.name = "spring", .lower = ground, .upper = body, .law = {.uses = &uses, .most_uses = 20}});
  CaseRun run{model, still_ground(1 * s), {.error_bars = ErrorBarMode::always}};
  EXPECT_THROW(run.run(), ConvergenceError);
  EXPECT_FALSE(run.result().error_bars.checked);
  EXPECT_EQ(run.result().error_bars.companion, "No error bars: the run did not reach its end.");
}

}  // namespace
}  // namespace moat
