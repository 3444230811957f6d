// The recipe "How to add an integrator" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include <cmath>

#include "analyses/integrators/step_equations.hpp"
#include "analyses/integrators/wood_bossak_zienkiewicz.hpp"
#include "elements/line/shear_spring.hpp"
#include "model/equation_of_motion.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Steps of an oscillator that the step does not resolve, taken by the library's own equations.
TEST(IntegratorRecipe, HasTheSpectralRadiusOfItsSource) {
  for (const double alpha : {0.0, -0.2, -0.5}) {
    Model model;
    const NodeId node = add(model, Node{.name = "mass", .mass = 1 * kg, .initial_displacement = 1 * m});
    add(model, ShearSpring{.name = "spring", .lower = ground, .upper = node, .stiffness = 1e8 * N / m});
    AnalysisState state{model};
    StepEquations equations{state};
    NewtonSolver newton{equations, {}};
    state.balance_committed_state({});
    const StepScheme scheme = WoodBossakZienkiewicz{.alpha = alpha}.scheme().value();
    const double step = 0.01;
    Vector acceleration = Vector::Zero(1);
    const auto advance = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        const double start = state.time();
        equations.begin({.length = step, .end_time = start + step, .start_time = start}, scheme, acceleration);
        EXPECT_TRUE(newton.solve(acceleration).converged);
        equations.complete();
        state.commit();
      }
      return std::abs(state.displacement(node));
    };
    // Two equal eigenvalues: the amplitude falls as (c + n) r^n. Successive ratios approach r.
    const double radius = (1.0 + alpha) / (1.0 - alpha);
    const double before = advance(8), after = advance(8);
    EXPECT_NEAR(std::pow(after / before, 1.0 / 8.0), radius, 0.1) << alpha;
  }
}

}  // namespace
}  // namespace moat::testing
