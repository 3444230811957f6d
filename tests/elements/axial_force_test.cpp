// Laws that take an axial force.

#include <gtest/gtest.h>

#include <string>

#include "elements/line/isolator.hpp"
#include "elements/line/spring.hpp"
#include "elements/plan/planar_spring.hpp"
#include "materials/linear.hpp"
#include "materials/plan/biaxial_friction_pendulum.hpp"
#include "materials/repeated.hpp"
#include "model/analysis_state.hpp"
#include "moved_model.hpp"

namespace moat {
namespace {

using namespace units;

// A pendulum under a weight that changes: F = N d/R.
struct Pendulum {
  double radius = 2.0;  // m

  struct State {
    double compression = 0.0;
  };
  Response evaluate(const State&, double d, double, Interval, AxialForce axial, State& trial) const {
    trial.compression = axial.compression;
    return {axial.compression * d / radius, axial.compression / radius, 0.0, d / radius};
  }
  double weight_lever(const State&, double d0, const State&, double d1) const { return 0.5 * d0 * d1 / radius; }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return 1.0; }
};
static_assert(AxialForceLaw<Pendulum> && ForceLaw<Pendulum> && !AxialForceLaw<Linear>);
static_assert(AxialForceLaw<Repeated<Pendulum>>);

TEST(AxialForces, ReachTheLaw) {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 1 * tonne, .initial_displacement = 10 * cm});
  add(model, Spring<Pendulum>{.name = "one", .lower = ground, .upper = a, .law = {}});
  add(model, Isolator<Pendulum>{.name = "four", .upper = a, .law = {}, .count = 4});
  add(model, Spring<Linear>{.name = "linear", .lower = ground, .upper = a, .law = {.stiffness = 1 * kN / m}});
  AnalysisState state{model};
  EXPECT_DOUBLE_EQ(state.internal_forces()[0], 100.0);
  EXPECT_TRUE(state.elements(2).axial_actions().compressions.empty());
  const long before = state.tangent_version();
  state.elements(0).axial_actions().compressions[0] = 50e3;
  state.elements(1).axial_actions().compressions[0] = 80e3;  // on all four
  state.evaluate();
  EXPECT_DOUBLE_EQ(state.elements(0).results()[0].force, 50e3 * 0.1 / 2.0);
  EXPECT_DOUBLE_EQ(state.elements(1).results()[0].force, 80e3 * 0.1 / 2.0);
  EXPECT_DOUBLE_EQ(state.internal_forces()[0], 130e3 * 0.1 / 2.0 + 100.0);
  EXPECT_GT(state.tangent_version(), before);
  SparseMatrix tangent = state.zero_matrix();
  state.assemble_tangent(0.0, 0.0, 1.0, tangent);
  EXPECT_DOUBLE_EQ(tangent.coeff(0, 0), 130e3 / 2.0 + 1e3);
}

static_assert(PlanarAxialForceLaw<PlanarSliderUnderWeight> && PlanarLaw<PlanarSliderUnderWeight>);
static_assert(PlanarLaw<BiaxialFrictionPendulum> && !PlanarAxialForceLaw<BiaxialFrictionPendulum>);

// On a straight way it slides: F = N (d/R + mu t) along the direction t, with the N of the instant.
TEST(AxialForces, ReachTheLawOfABearingInPlan) {
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab", .mass = 1 * tonne, .size = {4 * m, 4 * m}});
  const FrictionPendulum pendulum{.radius = 2 * m, .friction = 0.05};
  add(model, PlanBearing<PlanarSliderUnderWeight>{
                 .name = "bearing", .under = slab, .law = in_plan_under_changing_weight(pendulum, 80 * kN)});
  AnalysisState state{model};
  ASSERT_EQ(state.elements(0).axial_actions().compressions.size(), 1U);
  for (const double weight : {80e3, 50e3, 90e3}) {
    state.elements(0).axial_actions().compressions[0] = weight;
    const double d = state.motion().displacement.norm() + 0.1;
    const Vector forces = testing::forces_at(state, Vector{{0.6 * d, 0.8 * d, 0.0}}, Vector{{0.6, 0.8, 0.0}}, 0.1);
    const double expected = weight * (d / 2.0 + 0.05);
    EXPECT_NEAR(forces[0], 0.6 * expected, 1e-9 * expected) << weight;
    EXPECT_NEAR(forces[1], 0.8 * expected, 1e-9 * expected) << weight;
    state.commit();
  }
}

// Four equal pendulums slide along y under a moment M_x: N = W/4 + M_x x/100, so that they turn the slab by
// M_x (mu + d/R) = 1 MN m, the sum of their forces times their arms.
TEST(AxialForces, ThatDifferTurnASlab) {
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab", .mass = 1000 * tonne, .size = {12 * m, 8 * m}});
  const FrictionPendulum pendulum{.radius = 2 * m, .friction = 0.05};
  const PlanVector places[]{{-5.0, -3.0}, {5.0, -3.0}, {-5.0, 3.0}, {5.0, 3.0}};
  for (int i = 0; i < 4; ++i)
    add(model, PlanBearing<PlanarSliderUnderWeight>{.name = "bearing " + std::to_string(i),
                                                    .under = slab,
                                                    .at = {places[i].x * m, places[i].y * m},
                                                    .law = in_plan_under_changing_weight(pendulum, 2.5 * MN)});
  AnalysisState state{model};
  const auto compressions = state.elements(0).axial_actions().compressions;
  for (std::size_t i = 0; i < 4; ++i) compressions[i] = 2.5e6 + 10e6 * places[i].x / 100.0;
  const Vector forces = testing::forces_at(state, Vector{{0.0, 0.1, 0.0}}, Vector{{0.0, 0.1, 0.0}}, 0.1);
  EXPECT_NEAR(forces[0], 0.0, 1e-3);
  EXPECT_NEAR(forces[1], 10e6 * (0.05 + 0.1 / 2.0), 1e-3);
  EXPECT_NEAR(forces[2] * model.diaphragm(slab).gyration, 10e6 * (0.05 + 0.1 / 2.0), 1e-3);
}

// N falls through zero and rises again inside one step: the bearing lifted, though it presses at both ends.
TEST(AxialForces, ThatVanishInsideAStepAreSeen) {
  for (const double rate : {-2e6, -6e6}) {
    Model model;
    const NodeId a = add(model, Node{.name = "a", .mass = 1 * tonne});
    const FrictionPendulum pendulum{.radius = 2 * m, .friction = 0.05};
    add(model, Spring<SlidingUnderWeight>{
                   .name = "bearing", .lower = ground, .upper = a, .law = pendulum.under_changing_weight(50 * kN)});
    AnalysisState state{model};
    const AxialActions axial = state.elements(0).axial_actions();
    const double step = 0.05;
    axial.compressions[0] = 50e3;
    axial.rates[0] = rate;
    state.evaluate();
    state.commit();
    // The cubic through these values and rates is lowest in the middle: 50 kN + rate/4 step.
    axial.compressions[0] = 50e3;
    axial.rates[0] = -rate;
    testing::move_to(state, Vector{{0.0}}, Vector{{0.0}}, step);
    const RegimeScan scan = state.scan_regimes(step, -1e-13);
    const bool lifts = 50e3 + 0.25 * rate * step < 0.0;
    EXPECT_EQ(scan.crossed_back, lifts) << rate;
    EXPECT_EQ(scan.crossed, lifts) << rate;
    EXPECT_EQ(scan.fraction < 0.5, lifts) << rate;
  }
}

}  // namespace
}  // namespace moat
