// Laws that take an axial force.

#include <gtest/gtest.h>

#include "elements/line/isolator.hpp"
#include "elements/line/spring.hpp"
#include "materials/linear.hpp"
#include "materials/repeated.hpp"
#include "model/analysis_state.hpp"

namespace moat {
namespace {

using namespace units;

// A pendulum under a weight that changes: F = N d/R.
struct Pendulum {
  double radius = 2.0;  // m

  using State = NoState;
  Response evaluate(const State&, double d, double, Interval, AxialForce axial, State&) const {
    return {axial.compression * d / radius, axial.compression / radius, 0.0};
  }
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
  EXPECT_TRUE(state.elements(2).axial_forces().empty());
  const long before = state.tangent_version();
  state.elements(0).axial_forces()[0] = 50e3;
  state.elements(1).axial_forces()[0] = 80e3;  // on all four
  state.evaluate();
  EXPECT_DOUBLE_EQ(state.elements(0).results()[0].force, 50e3 * 0.1 / 2.0);
  EXPECT_DOUBLE_EQ(state.elements(1).results()[0].force, 80e3 * 0.1 / 2.0);
  EXPECT_DOUBLE_EQ(state.internal_forces()[0], 130e3 * 0.1 / 2.0 + 100.0);
  EXPECT_GT(state.tangent_version(), before);
  SparseMatrix tangent = state.zero_matrix();
  state.assemble_tangent(0.0, 0.0, 1.0, tangent);
  EXPECT_DOUBLE_EQ(tangent.coeff(0, 0), 130e3 / 2.0 + 1e3);
}

}  // namespace
}  // namespace moat
