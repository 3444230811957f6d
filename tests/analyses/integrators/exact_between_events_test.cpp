// Exact steps against closed forms, against Newmark's method, and against the peaks of an independent program.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analyses/integrators/exact_method.hpp"
#include "analysis_testing.hpp"
#include "counted_allocations.hpp"
#include "law_cases.hpp"
#include "message_of.hpp"
#include "paper_building.hpp"
#include "reference_rows.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;
using std::numbers::pi;

TransientOptions exact_options() { return {.integrator = ExactBetweenEvents{}}; }

TEST(ExactBetweenEvents, AnElastoplasticMassStopsWhereItsEnergyIsSpent) {
  constexpr double yield_force = 1e5, yield_displacement = 0.01, speed = 2.0, body = 5000.0;
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = body * kg, .initial_velocity = speed * m / s});
  add(model, LeadRubberBearing{.upper = node,
                               .yield_force = yield_force * N,
                               .yield_displacement = yield_displacement * m,
                               .post_yield_stiffness = 0 * N / m});
  std::vector<MotionState> events;
  Transient analysis{model, still_ground(0.5 * s), exact_options()};
  Watch watch{[&](const StepView& view) {
    if (!view.on_grid && (events.empty() || events.back().time != view.state.time()))
      events.push_back(view.state.motion());
  }};
  analysis.attach(watch);
  analysis.run();

  const double w = std::sqrt(yield_force / yield_displacement / body);
  const double yield_time = std::asin(w * yield_displacement / speed) / w;
  const double yield_speed = std::sqrt(speed * speed - std::pow(w * yield_displacement, 2));
  const double deceleration = yield_force / body;
  const double largest = yield_displacement + yield_speed * yield_speed / (2.0 * deceleration);
  // Yield is noticed 1e-9 beyond the yield displacement. Then it unloads and vibrates about its slip.
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(events[0].time, yield_time, 1e-10);
  EXPECT_NEAR(events[0].displacement[0], yield_displacement, 2e-11);
  EXPECT_NEAR(events[1].time, yield_time + yield_speed / deceleration, 1e-9);
  EXPECT_NEAR(events[1].displacement[0], largest, 1e-9);
  const double since = w * (analysis.state().time() - events[1].time);
  EXPECT_NEAR(analysis.state().motion().displacement[0], largest - yield_displacement * (1.0 - std::cos(since)), 1e-9);
}

Model paper_model(const LawCase& law) {
  Model model;
  law.add_moat(model, add(model, paper_building()).base);
  return model;
}

CaseResult run(const Model& model, const GroundMotion& motion, TransientOptions options) {
  return run_case(model, motion, {.transient = options, .history_interval = 10 * ms});
}

// A motion that makes the paper's building slide, unload and pound: samples of a sine every 10 ms, and `between` more
// on the straight lines between them.
GroundMotion pieced_sine(double amplitude, int between = 0, double duration = 6.0) {
  constexpr double interval = 0.01;
  const auto intervals = static_cast<int>(std::lround(duration / interval));
  const auto sine = [&](int sample) { return amplitude * std::sin(5.0 * interval * sample); };
  const int parts = between + 1;
  std::vector<double> samples{sine(0)};
  for (int i = 0; i < intervals; ++i)
    for (int part = 1; part <= parts; ++part) samples.push_back(sine(i) + (sine(i + 1) - sine(i)) * part / parts);
  return {"sine", interval / parts, samples};
}

const LawCase no_gap{"no_pounding", [](Model&, NodeId) {}};

// Largest difference of a history at the instants of the samples, where no peak is interpolated, relative to its
// largest value; of all histories but energies, which are formed step by step from different steps.
double largest_difference_of_histories(const CaseResult& one, const CaseResult& other) {
  double worst = 0.0;
  for (std::size_t c = 0; c < one.histories.columns.size(); ++c) {
    const Column &ours = one.histories.columns[c], &theirs = other.histories.columns[c];
    if (ours.unit == "J") continue;
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < ours.values.size(); ++i) {
      largest = std::max(largest, std::abs(theirs.values.at(i)));
      difference = std::max(difference, std::abs(ours.values[i] - theirs.values[i]));
    }
    worst = std::max(worst, difference / largest);
  }
  return worst;
}

TEST(ExactBetweenEvents, YieldAndUnloadingAgreeWithNewmarkAtAFineStep) {
  const GroundMotion motion = pieced_sine(2.0);
  const CaseResult exact = run(paper_model(no_gap), motion, exact_options());
  const CaseResult newmark = run(paper_model(no_gap), motion, {.step = 0.1 * ms});
  EXPECT_EQ(exact.solver.events, newmark.solver.events);
  EXPECT_GT(exact.solver.events, 10);
  EXPECT_EQ(exact.solver.newton_iterations, 0);
  // Newmark's error is of second order: half the step leaves a quarter of the difference.
  const double difference = largest_difference_of_histories(exact, newmark);
  EXPECT_LT(difference, 1e-5);
  const CaseResult finer = run(paper_model(no_gap), motion, {.step = 0.05 * ms});
  EXPECT_NEAR(order(difference, largest_difference_of_histories(exact, finer)), 2.0, 0.2);
}

TEST(ExactBetweenEvents, ShorterStepsChangeNothing) {
  const CaseResult whole = run(paper_model(no_gap), pieced_sine(2.0), exact_options());
  const CaseResult fifths =
      run(paper_model(no_gap), pieced_sine(2.0, 4), {.integrator = ExactBetweenEvents{}, .largest_step = 2 * ms});
  EXPECT_GT(fifths.solver.accepted_steps, 2 * whole.solver.accepted_steps);
  EXPECT_EQ(whole.solver.events, fifths.solver.events);
  EXPECT_LT(largest_difference_of_histories(whole, fifths), 1e-10);
}

TEST(ExactBetweenEvents, TouchesAFreeBodyExactlyWhereItMeetsTheWall) {
  constexpr double clearance = 0.01234, speed = 0.4;
  const CaseResult result = run(body_before_wall(LinearElastic{.stiffness = 5.8e8 * N / m}, 5.5e5, speed, clearance),
                                still_ground(0.4 * s), exact_options());
  ASSERT_EQ(result.impacts.size(), 1u);
  EXPECT_NEAR(result.impacts[0].start, clearance / speed, 1e-11);
  EXPECT_NEAR(result.impacts[0].approach_speed, speed, 1e-12);
  EXPECT_NEAR(result.impacts[0].rebound_ratio, 1.0, 1e-6);
  EXPECT_NEAR(result.impacts[0].duration, pi * std::sqrt(5.5e5 / 5.8e8), 1e-3 * result.impacts[0].duration);
}

TEST(ExactBetweenEvents, RefusesAModelThatIsNotLinearBetweenEvents) {
  Model model;
  add(model, paper_building());
  add(model, Isolator<NonlinearViscous>{.name = "damper", .upper = NodeId{0}, .law = NonlinearViscous::typical()});
  EXPECT_EQ(message_of([&] { Transient(model, still_ground(1 * s), exact_options()); }),
            "TransientOptions: integrator = ExactBetweenEvents{} needs elements that are linear between located "
            "events, and \"damper\" is not. Use Newmark{}, or a law whose changes of stiffness are located.");
}

TEST(ExactBetweenEvents, RefusesALargeModel) {
  Model model;
  for (int i = 0; i <= ExactMethod::most_degrees_of_freedom; ++i)
    add(model, Node{.name = "node " + std::to_string(i), .mass = 1 * kg});
  EXPECT_EQ(message_of([&] { Transient(model, still_ground(1 * s), exact_options()); }),
            "TransientOptions: integrator = ExactBetweenEvents{} is for at most 50 degrees of freedom; the model has "
            "51. Use Newmark{}.");
}

TEST(ExactBetweenEvents, RefusesAVibrationFarFasterThanTheSamples) {
  // 1e6 1/s over 10 ms / 4096 is 2.4, and a half is allowed.
  Model model = oscillator({.frequency = 1e6});
  EXPECT_EQ(message_of([&] { Transient(model, still_ground(1 * s), exact_options()); }),
            "TransientOptions: integrator = ExactBetweenEvents{} would need more than 4096 steps from one sample of "
            "the motion to the next: the fastest eigenvalue of the model is 1e+06 1/s. Look for a very stiff spring "
            "or damper at a small mass, or use Newmark{}.");
}

TEST(ExactBetweenEvents, ListsTheExactPartsAmongTheAssumptions) {
  Model model = oscillator({});
  const Transient analysis{model, still_ground(1 * s), exact_options()};
  EXPECT_TRUE(
      analysis.assumptions().front().starts_with("Exact steps while no gap is closed; in contact: Newmark's method"))
      << analysis.assumptions().front();
}

TEST(ExactBetweenEvents, AsksForNoMemoryOnceItsMatricesAreKnown) {
  Model model = paper_model(no_gap);
  Transient analysis{model, pieced_sine(2.0, 0, 20.0), exact_options()};
  while (analysis.state().time() < 5.0) analysis.advance();
  const long events = analysis.statistics().events, before = count_of_allocations();
  while (!analysis.finished()) analysis.advance();
  EXPECT_EQ(count_of_allocations(), before);
  EXPECT_GT(analysis.statistics().events, events + 10);
}

using ExactOnRecords = OnReferenceRecords;

TEST_P(ExactOnRecords, EveryLawIsWithinAThousandthOfTheReferenceWithDefaults) {
  for (const LawCase& law : all_laws()) {
    SCOPED_TRACE(law.row);
    const Row row = reference_row(record(), law.row);
    const CaseResult result = run(paper_model(law), *motion_, exact_options());
    EXPECT_LT(largest_error(result, row), 1e-3);
    EXPECT_EQ(static_cast<int>(result.impacts.size()), std::stoi(row.at("impacts")));
    EXPECT_TRUE(result.warnings.empty());
  }
}

TEST_P(ExactOnRecords, BuildingsThatNeverTouchAreWithinThreeHundredThousandths) {
  const CaseResult isolated = run(paper_model(no_gap), *motion_, exact_options());
  EXPECT_LT(largest_error(isolated, reference_row(record(), "no_pounding")), 3e-5);
  Model fixed;
  add(fixed, paper_building_on_fixed_base());
  const CaseResult result = run(std::move(fixed), *motion_, exact_options());
  EXPECT_EQ(result.solver.newton_iterations, 0);
  const Row row = reference_row(record(), "fixed_base");
  EXPECT_NEAR(peak(result, "displacement", "floor 5") / (0.01 * std::stod(row.at("top_displacement_cm"))), 1.0, 3e-5);
  EXPECT_NEAR(peak(result, "absolute_acceleration", "floor 5") / std::stod(row.at("top_acceleration_m_s2")), 1.0, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Records, ExactOnRecords,
                         ::testing::Values("RSN1161_KOCAELI_GBZ000", "RSN982_NORTHR_JEN022", "RSN803_LOMAP_WVC270"),
                         [](const auto& record) { return std::string{record.param}; });

}  // namespace
}  // namespace moat
