// A law whose change is located and then does not happen.
#include <gtest/gtest.h>

#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

// A spring that expects a change 1e-10 m farther on than the deformation of its state.
struct NeverChanges {
  struct State {
    double deformation = 0.0;  // m
  };
  double stiffness = 1e6;  // N/m

  Response evaluate(const State&, double d, double, State& trial) const {
    trial.deformation = d;
    return {.force = stiffness * d, .stiffness = stiffness};
  }
  double stored_energy(const State&, double d) const { return 0.5 * stiffness * d * d; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness; }
  double regime_margin(const State& state, double d, double) const { return state.deformation + 1e-10 - d; }
  State next_regime(const State& state, double, double) const { return state; }
};

TEST(VainCuts, DoNotStopTheAnalysis) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 1000 * kg});
  add(model, Isolator<NeverChanges>{.upper = node, .law = {}});
  Transient analysis{model, GroundMotion{"push", 0.01, std::vector<double>(101, -1.0)}, {.step = 1 * ms}};
  constexpr long most_steps = 20000;
  while (!analysis.finished() && analysis.statistics().accepted_steps < most_steps) analysis.advance();
  EXPECT_TRUE(analysis.finished());
  EXPECT_EQ(analysis.statistics().events, 0);
  // A warning says so.
  const long passed = analysis.statistics().passed_changes;
  EXPECT_GT(passed, 0);
  ASSERT_EQ(analysis.warnings().size(), 1U);
  EXPECT_TRUE(analysis.warnings()[0].starts_with(std::to_string(passed) + " change"));
  EXPECT_NE(analysis.warnings()[0].find("could not be located"), std::string::npos);
}

}  // namespace
}  // namespace moat::testing
