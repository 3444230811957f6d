// Results with several threads.

#include <gtest/gtest.h>

#include <cmath>

#include "analyses/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/gap.hpp"
#include "elements/spring.hpp"
#include "materials/linear.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"
#include "output/energy_ledger.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// A row of isolated buildings with gaps between their bases and between points on their columns, some at different
// heights, and all first floors tied to one walkway; enough elements of every kind to be shared out.
Model street(int buildings) {
  Model model;
  const NodeId walkway = add(model, Node{.name = "walkway", .mass = 5000 * tonne});
  BuildingNodes before;
  for (int i = 0; i < buildings; ++i) {
    ShearBuilding building = paper_building("building " + std::to_string(i));
    building.floor_mass = (400.0 + 200.0 * std::fmod(0.618 * i, 1.0)) * tonne;
    const BuildingNodes nodes = add(model, building);
    const std::string number = std::to_string(i);
    add(model,
        Spring<Linear>{
            .name = "tie " + number, .lower = walkway, .upper = nodes.floors[0], .law = {.stiffness = 100 * kN / m}});
    if (i > 0) {
      add(model, Gap<HertzDamp>{.name = "gap " + number,
                                .left = before.base,
                                .right = nodes.base,
                                .clearance = 2 * mm,
                                .law = paper_hertz_damp()});
      add(model, Gap<HertzDamp>{.name = "floor gap " + number,
                                .left = MemberPoint{before.floors[1], before.floors[2], 0.4},
                                .right = nodes.floors[2],
                                .clearance = 3 * mm,
                                .law = paper_hertz_damp()});
    }
    before = nodes;
  }
  return model;
}

struct Outcome {
  MotionState state;
  EnergyBalance energy;
  SolverStatistics statistics;
};

Outcome outcome(Model model, int threads) {
  const GroundMotion motion = near_fault_pulse({.pulse_period = 1.0 * s}).scaled_to_pga(0.4 * g);
  // Events within the band are taken where the step ends, else thousands of gaps would cut every step.
  Transient analysis{model, motion, {.step = 5 * ms, .threads = threads, .end = 2 * s, .location_tolerance = 20 * mm}};
  EnergyLedger ledger;
  analysis.attach(ledger);
  analysis.run();
  return {model.state(), ledger.balance(model), analysis.statistics()};
}

TEST(Threads, ChangeNoBitOfTheResult) {
  constexpr int buildings = 4200;
  const Model model = street(buildings);
  const Outcome one = outcome(model, 1);
  ASSERT_GT(one.statistics.events, 10);
  ASSERT_GT(one.energy.impact, 0.0);
  for (const int threads : {2, 3}) {
    const Outcome several = outcome(model, threads);
    EXPECT_EQ(one.state.displacement, several.state.displacement);
    EXPECT_EQ(one.state.velocity, several.state.velocity);
    EXPECT_EQ(one.state.acceleration, several.state.acceleration);
    EXPECT_EQ(one.energy.integration_error, several.energy.integration_error);
    EXPECT_EQ(one.energy.impact, several.energy.impact);
    EXPECT_EQ(one.statistics.accepted_steps, several.statistics.accepted_steps);
    EXPECT_EQ(one.statistics.newton_iterations, several.statistics.newton_iterations);
  }
}

TEST(Threads, AtLeastOneIsNeeded) {
  Model model = street(1);
  EXPECT_EQ(message_of([&] { Transient(model, still_ground(1 * s), {.threads = 0}); }),
            "TransientOptions: threads = 0 is not allowed; it must be >= 1.");
}

}  // namespace
}  // namespace moat
