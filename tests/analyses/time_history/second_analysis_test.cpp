// An analysis starts at rest, or goes on from a state: under the motion that led there, and under no other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "analysis_testing.hpp"
#include "message_of.hpp"
#include "moat.hpp"
#include "paper_building.hpp"
#include "peak_in.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

Model in_plan() {
  Model model;
  add(model, small_plan_building(
                 1, {.yield_force = 1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 5 * MN / m}));
  return model;
}

// It moves from 1.4 s to 4 s.
GroundMotion pulse(double quiet_after = 0.0) {
  return near_fault_pulse({.pulse_period = 1.3 * s, .quiet_after = quiet_after * s}).scaled_to_pga(0.3 * g);
}

GroundMotion of_samples(std::string name, double interval, std::vector<double> samples) {
  return {std::move(name), interval, std::move(samples)};
}

std::vector<double> samples_of(const GroundMotion& motion) {
  return {motion.samples().begin(), motion.samples().end()};
}

GroundMotion extended(const GroundMotion& motion, double by) {
  std::vector<double> samples = samples_of(motion);
  samples.resize(samples.size() + static_cast<std::size_t>(by / motion.time_step()), 0.0);
  return of_samples("another name", motion.time_step(), samples);
}

// With so many samples for one.
GroundMotion resampled(const GroundMotion& motion, int parts) {
  const double interval = motion.time_step() / parts;
  std::vector<double> samples;
  for (std::size_t i = 0; i + 1 < motion.samples().size(); ++i)
    for (int k = 0; k < parts; ++k)
      samples.push_back(motion.samples()[i] + k * (motion.samples()[i + 1] - motion.samples()[i]) / parts);
  samples.push_back(motion.samples().back());
  return of_samples("resampled", interval, samples);
}

const char* const remedy =
    "Make a Transient without a state, which starts at rest. For shocks one after the other give one motion, "
    "joined({first, second}, 20 * s).";

AnalysisState state_after(const Model& model, const GroundMotion& motion, const TransientOptions& options = {}) {
  Transient analysis{model, motion, options};
  analysis.run();
  return analysis.state();
}

EndedCase run_from(AnalysisState start, const GroundMotion& motion, const TransientOptions& options) {
  const Model& model = start.model();
  Transient analysis{model, motion, std::move(start), options};
  EnergyLedger energy;
  PeakRecorder peaks{model};
  HistoryRecorder histories{model, motion.time_step()};
  for (StepObserver* observer : std::initializer_list<StepObserver*>{&energy, &peaks, &histories})
    analysis.attach(*observer);
  analysis.run();
  EndedCase ended{{}, analysis.state()};
  ended.result.peaks = peaks.peaks();
  ended.result.energy = energy.at_end();
  ended.result.histories = histories.take_table();
  ended.result.warnings = analysis.warnings();
  return ended;
}

// Runs do not change their model.
TEST(SecondAnalysis, OfAModelStartsAtRest) {
  const Model model = pounding_building();
  const CaseResult at_first = run_case(model, pulse());
  (void)run_case(model, pulse().scaled_by(2.0));
  const CaseResult again = run_case(model, pulse());
  ASSERT_EQ(again.peaks.size(), at_first.peaks.size());
  for (std::size_t i = 0; i < again.peaks.size(); ++i) EXPECT_EQ(again.peaks[i].value, at_first.peaks[i].value) << i;
}

TEST(SecondAnalysis, UnderAnotherMotionIsRefused) {
  const GroundMotion first = pulse(), longer = pulse(3.0);
  std::vector<double> one_other = samples_of(longer);
  one_other[one_other.size() / 3] *= 1.0 + 1e-6;
  const std::vector<GroundMotion> others{
      longer.scaled_by(1.01),
      longer.scaled_by(-1.0),
      near_fault_pulse({.pulse_period = 1.31 * s, .quiet_after = 3 * s}).scaled_to_pga(0.3 * g),
      of_samples("one sample differs", longer.time_step(), one_other),
      of_samples("same samples at another interval", 1.01 * longer.time_step(), samples_of(longer)),
      still_ground(20 * s)};
  const Model model = pounding_building();
  const AnalysisState moved = state_after(model, first);
  for (const GroundMotion& other : others) {
    SCOPED_TRACE(other.name());
    const std::string message =
        "Transient \"" + other.name() + "\": the state stands at t = " + to_text(first.duration()) +
        " s under other accelerations of the ground, those of \"" + first.name() + "\". " + remedy;
    EXPECT_EQ(message_of([&] { Transient{model, other, moved}; }), message);
    // So is a run that would end before.
    EXPECT_EQ(message_of([&] { Transient{model, other, moved, {.end = 1 * s}}; }), message);
  }
}

TEST(SecondAnalysis, OfASecondComponentOrAnotherIncidenceIsRefused) {
  const PlanMotion pair{pulse(), pulse().scaled_by(0.4), 20 * deg};
  const Model model = in_plan();
  const AnalysisState moved = state_after(model, pair, {.end = 2 * s});
  const auto refused = [&](const GroundMotion& other) {
    return message_of([&] { Transient{model, other, moved}; }).find(remedy) != std::string::npos;
  };
  EXPECT_TRUE(refused(pair.rotated(1 * deg)));
  EXPECT_TRUE(refused(PlanMotion{pair.second, pair.first, pair.incidence}));
  EXPECT_TRUE(refused(of_samples("along x alone", pair.first.time_step(), samples_of(pair))));
  EXPECT_FALSE(refused(pair));
  EXPECT_FALSE(refused(PlanMotion{pair.first.scaled_by(2.0).scaled_by(0.5), pair.second, pair.incidence}));
}

// In two parts: by the same motion, under another name, with more zeros, with more samples.
TEST(SecondAnalysis, UnderTheSameMotionGoesOn) {
  const GroundMotion motion = pulse(1.0);
  const Model model = pounding_building();
  const TransientOptions options{.tolerance = 1e-8, .largest_step = 2.5 * ms};
  const CaseResult whole = run_case(model, motion, {.transient = options});
  ASSERT_GT(whole.impacts.size(), 1u);
  for (const double middle : {1.8, 2.3037, motion.duration()})
    for (const GroundMotion& same :
         {motion, extended(motion, 2.0), resampled(motion, 2), resampled(extended(motion, 4.0), 4)}) {
      SCOPED_TRACE(::testing::Message() << same.name() << " from " << middle);
      TransientOptions first_part = options, second_part = options;
      first_part.end = middle * s;
      second_part.end = same.duration() > motion.duration() ? same.duration() * s : motion.duration() * s;
      const auto [first, state] = run_from(AnalysisState{model}, motion, first_part);
      if (second_part.end.si() <= middle) continue;
      const CaseResult second = run_from(state, same, second_part).result;
      for (const CaseResult* part : {&first, &second}) {
        EXPECT_TRUE(part->warnings.empty()) << part->warnings.front();
        EXPECT_LT(part->energy.error_share(), 1e-5);
      }
      EXPECT_EQ(second.histories.values("time").front(),
                std::ceil(middle / same.time_step() - 1e-9) * same.time_step());
      const double largest = std::max(peak(first, "displacement", "base"), peak(second, "displacement", "base"));
      EXPECT_NEAR(largest, peak(whole, "displacement", "base"), 1e-5 * largest);
      if (same.duration() > motion.duration()) continue;
      EXPECT_NEAR(first.energy.input + second.energy.input, whole.energy.input, 1e-5 * whole.energy.largest_input);
      EXPECT_NEAR(first.energy.impact + second.energy.impact, whole.energy.impact, 1e-5 * whole.energy.largest_input);
      EXPECT_NEAR(first.energy.strain + second.energy.strain, whole.energy.strain, 1e-5 * whole.energy.largest_input);
    }
}

TEST(SecondAnalysis, GoesOnUnderAMotionJoinedToItsOwn) {
  const GroundMotion first = pulse(), both = joined({first, first.scaled_by(-0.8)}, 2 * s);
  const TransientOptions options{.tolerance = 1e-8, .largest_step = 2.5 * ms};
  const Model model = pounding_building();
  const auto [whole, at_once] = run_to_end(model, both, {.transient = options});
  const auto [second, in_parts] = run_from(state_after(model, first, options), both, options);
  EXPECT_TRUE(second.warnings.empty());
  EXPECT_NEAR(at_once.displacement(NodeId{0}), in_parts.displacement(NodeId{0}),
              1e-5 * peak(whole, "displacement", "base"));
}

TEST(SecondAnalysis, OfInitialVelocitiesIsNoSecondOne) {
  const Model model = oscillator({.velocity = 1.0});
  const Transient first{model, still_ground(1 * s)};
  EXPECT_NO_THROW((Transient{model, pulse(), first.state()})) << "nothing has moved yet";
}

TEST(SecondAnalysis, EndsBehindItsStart) {
  const Model model = oscillator({.velocity = 1.0});
  const AnalysisState moved = state_after(model, still_ground(2 * s));
  EXPECT_EQ(message_of([&] {
              Transient{model, still_ground(2 * s), moved};
            }),
            "Transient \"still ground\": the state stands at t = 2 s, and the analysis ends at 2 s. Make a Transient "
            "without a state, which starts at rest, or give a later TransientOptions::end.");
}

// The energies of the elements are kept by the state, the input by the ledger.
TEST(SecondAnalysis, CountsAllEnergiesFromItsStart) {
  const GroundMotion motion = pulse(2.0);
  const Model model = pounding_building();
  AnalysisState state{model};
  for (const double end : {1.9, 2.6, 3.3, 5.5}) {
    SCOPED_TRACE(end);
    EndedCase part = run_from(std::move(state), motion, {.end = end * s});
    const EnergyBalance& energy = part.result.energy;
    EXPECT_LT(energy.error_share(), 1e-3);
    const double sum = energy.kinetic + energy.strain + energy.viscous + energy.hysteretic + energy.impact;
    EXPECT_NEAR(sum, energy.input, 2e-3 * std::max(energy.largest_input, energy.largest_kinetic));
    state = std::move(part.state);
  }
}

}  // namespace
}  // namespace moat
