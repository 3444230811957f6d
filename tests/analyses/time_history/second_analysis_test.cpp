// A model that stands at t > 0 goes on under its own motion, and is refused under another.

#include <gtest/gtest.h>

#include <cmath>
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
    "Copy the model before its first analysis, and give every motion a copy. For shocks one after the other give one "
    "motion, joined({first, second}, 20 * s).";

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
  Model moved = pounding_building();
  (void)run_case(moved, first);
  for (const GroundMotion& other : others) {
    SCOPED_TRACE(other.name());
    const std::string message =
        "Transient \"" + other.name() + "\": the model stands at t = " + to_text(first.duration()) +
        " s under other accelerations of the ground, those of \"" + first.name() + "\". " + remedy;
    EXPECT_EQ(message_of([&] { Transient{moved, other}; }), message);
    EXPECT_EQ(message_of([&] { (void)run_case(moved, other); }), message);
    EXPECT_EQ(message_of([&] { (void)peaks_of(moved, other); }), message);
    // So is a copy of the moved model, and a run that would end before.
    Model copy = moved;
    EXPECT_EQ(message_of([&] { (void)run_case(copy, other, {.transient = {.end = 1 * s}}); }), message);
  }
}

TEST(SecondAnalysis, OfASecondComponentOrAnotherIncidenceIsRefused) {
  const PlanMotion pair{pulse(), pulse().scaled_by(0.4), 20 * deg};
  const auto refused = [&](const GroundMotion& other) {
    Model model = in_plan();
    (void)run_case(model, pair, {.transient = {.end = 2 * s}});
    return message_of([&] { (void)run_case(model, other); }).find(remedy) != std::string::npos;
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
  Model whole_model = pounding_building();
  const TransientOptions options{.tolerance = 1e-8, .largest_step = 2.5 * ms};
  const CaseResult whole = run_case(whole_model, motion, {.transient = options});
  ASSERT_GT(whole.impacts.size(), 1u);
  for (const double middle : {1.8, 2.3037, motion.duration()})
    for (const GroundMotion& same :
         {motion, extended(motion, 2.0), resampled(motion, 2), resampled(extended(motion, 4.0), 4)}) {
      SCOPED_TRACE(::testing::Message() << same.name() << " from " << middle);
      Model model = pounding_building();
      TransientOptions first_part = options, second_part = options;
      first_part.end = middle * s;
      second_part.end = same.duration() > motion.duration() ? same.duration() * s : motion.duration() * s;
      const CaseResult first = run_case(model, motion, {.transient = first_part});
      if (second_part.end.si() <= middle) continue;
      const CaseResult second = run_case(model, same, {.transient = second_part});
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
  Model at_once = pounding_building(), in_parts = pounding_building();
  const CaseResult whole = run_case(at_once, both, {.transient = options});
  (void)run_case(in_parts, first, {.transient = options});
  const CaseResult second = run_case(in_parts, both, {.transient = options});
  EXPECT_TRUE(second.warnings.empty());
  const Model &one = at_once, &other = in_parts;
  EXPECT_NEAR(one.displacement(NodeId{0}), other.displacement(NodeId{0}), 1e-5 * peak(whole, "displacement", "base"));
}

TEST(SecondAnalysis, OfInitialVelocitiesIsNoSecondOne) {
  Model model = oscillator({.velocity = 1.0});
  EXPECT_NO_THROW((Transient{model, still_ground(1 * s)}));
  EXPECT_NO_THROW((void)run_case(model, pulse())) << "nothing has moved yet";
}

// The energies of the elements are kept by the model, the input by the ledger.
TEST(SecondAnalysis, CountsAllEnergiesFromItsStart) {
  const GroundMotion motion = pulse(2.0);
  Model model = pounding_building();
  EnergyLedger ledger;
  for (const double end : {1.9, 2.6, 3.3, 5.5}) {
    SCOPED_TRACE(end);
    Transient analysis{model, motion, {.end = end * s}};
    analysis.attach(ledger);
    analysis.run();
    const EnergyBalance energy = ledger.balance(model);
    EXPECT_LT(energy.error_share(), 1e-3);
    const double sum = energy.kinetic + energy.strain + energy.viscous + energy.hysteretic + energy.impact;
    EXPECT_NEAR(sum, energy.input, 2e-3 * std::max(energy.largest_input, energy.largest_kinetic));
  }
}

TEST(SecondAnalysis, EndsTheFirst) {
  const GroundMotion motion = pulse();
  Model model = pounding_building();
  Transient first{model, motion};
  first.advance();
  Transient second{model, motion};
  second.advance();
  EXPECT_NE(message_of([&] { first.advance(); }).find("after another analysis of it."), std::string::npos);
  second.advance();
}

}  // namespace
}  // namespace moat
