// Allocations in steps.

#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "moat.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

class Allocation : public ::testing::TestWithParam<TransientOptions> {};

// The whole path: model, NOX, KLU, event checks, ledger and peaks, through impacts and yielding.
TEST_P(Allocation, NoStepAsksForMemoryOnceEverythingHasHappened) {
  ShearBuilding building = paper_building();
  if (!is_exact(GetParam().integrator)) building.isolation = unlocated_paper_bearings();
  Model model = pounding_building(10 * cm, building);
  Transient analysis{model, near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g), GetParam()};
  EnergyLedger ledger;
  PeakRecorder peaks{model};
  analysis.attach(ledger);
  analysis.attach(peaks);
  long steps = 0, steps_that_ask = 0, last_that_asks = 0, events_before = 0;
  while (!analysis.finished()) {
    const long before = count_of_allocations();
    analysis.advance();
    ++steps;
    if (count_of_allocations() == before) continue;
    ++steps_that_ask;
    last_that_asks = steps;
    events_before = analysis.statistics().events;
  }
  // The first steps, the first factors and the first change of every kind may allocate.
  EXPECT_LE(steps_that_ask, 6);
  EXPECT_LT(last_that_asks, steps / 2);
  EXPECT_GE(analysis.statistics().events, events_before + 4) << "touches and separations came after the last request";
}

INSTANTIATE_TEST_SUITE_P(Integrators, Allocation,
                         ::testing::Values(TransientOptions{}, TransientOptions{.step = 2.5 * ms},
                                           TransientOptions{.integrator = ExactBetweenEvents{}}),
                         [](const auto& options) {
                           if (is_exact(options.param.integrator)) return "ExactBetweenEvents";
                           return options.param.step.si() > 0.0 ? "FixedStep" : "AdaptiveStep";
                         });

}  // namespace
}  // namespace moat
