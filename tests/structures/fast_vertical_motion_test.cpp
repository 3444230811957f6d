// Sliders in series under a weight that changes fast, with bearings that lift.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "block_on_bearings.hpp"
#include "moat.hpp"
#include "output/recorders/energy_ledger.hpp"

namespace moat::testing {
namespace {

using namespace units;

struct Run {
  double displacement = 0.0;  // m, at the end
  long steps = 0, events = 0;
  double flight = 0.0, energy_error = 0.0;  // s, 1
};

Run run(const Model& model, double step, double up_amplitude = 4.0) {
  constexpr long most_steps = 100000;
  Transient analysis{model, shaking_along_and_up(1.0, up_amplitude), {.step = step * s, .force_tolerance = 1e-10}};
  EnergyLedger ledger;
  analysis.attach(ledger);
  while (!analysis.finished() && analysis.statistics().accepted_steps < most_steps) analysis.advance();
  EXPECT_TRUE(analysis.finished());
  return {analysis.state().motion().displacement[0], analysis.statistics().accepted_steps, analysis.statistics().events,
          analysis.state().weights()[0].rocking_time(), ledger.totals(analysis.state()).error_share()};
}

const DoublePendulum double_pendulum{
    .first_radius = 1 * m, .second_radius = 1 * m, .first_friction = 0.04, .second_friction = 0.08};

// A step is cut once at a change, and a bearing has a few changes between turns.
template <class Law>
void expect_few_steps_and_balanced_energy(const Law& law) {
  for (const double height : {0.0, 10.0})
    for (const double up_amplitude : {4.0, 12.0}) {
      const Run run_of_block = run(block_on(law, height), 1e-3, up_amplitude);
      EXPECT_GT(run_of_block.events, 20) << height;
      EXPECT_LT(run_of_block.events, 3000) << height;
      EXPECT_LE(run_of_block.steps, 6000 + 2 * run_of_block.events) << height;
      EXPECT_LT(run_of_block.energy_error, 1e-6) << height;
      EXPECT_EQ(run_of_block.flight > 0.0, up_amplitude > 9.80665) << height;
    }
}

TEST(FastVerticalMotion, DoublePendulumsPassTheirCorners) { expect_few_steps_and_balanced_energy(double_pendulum); }

TEST(FastVerticalMotion, TriplePendulumsPassTheirCorners) {
  expect_few_steps_and_balanced_energy(TriplePendulum::typical());
}

// Between samples the vertical component is linear and steps end at changes of regime. Friction that a falling weight
// sheds is right to second order: with an error of first order the last halving would leave 1e-4 m.
TEST(FastVerticalMotion, FixedStepsConverge) {
  const Model model = block_on(double_pendulum, 0.0);
  const double coarse = run(model, 2e-3).displacement, middle = run(model, 1e-3).displacement,
               fine = run(model, 0.5e-3).displacement;
  EXPECT_NEAR(coarse, fine, 1e-5);
  EXPECT_NEAR(middle, fine, 5e-6);
}

}  // namespace
}  // namespace moat::testing
