// Elements with constant tangents, as matrices: the same forces as from the elements one by one.
#include "model/linear_part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "elements/spring.hpp"
#include "materials/linear.hpp"
#include "moat_model.hpp"
#include "model/model.hpp"
#include "random_model.hpp"
#include "small_plan_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

void move(Model& model) {
  MotionState& trial = model.trial();
  trial = model.state();
  trial.time += 1e-3;
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    trial.displacement[i] += 0.01 * std::sin(1.0 + i);
    trial.velocity[i] += 0.3 * std::cos(2.0 + 3.0 * i);
    trial.acceleration[i] += 5.0 * std::sin(3.0 - 2.0 * i);
  }
  model.evaluate();
  model.evaluate_rates();
}

// Forces of all elements one by one, at the trial state.
Vector forces_of_elements(const Model& model, Vector& rates) {
  const MotionState& trial = model.trial();
  Vector forces = Vector::Zero(model.degrees_of_freedom() + 1);
  rates = forces;
  for (const auto& block : model.blocks()) {
    block->evaluate(trial.displacement.data(), trial.velocity.data(), forces.data());
    block->evaluate_rates(trial.acceleration.data(), rates.data());
  }
  return forces.head(model.degrees_of_freedom());
}

void expect_forces_of_elements(Model& model) {
  model.prepare();
  move(model);
  const Vector forces = model.internal_forces().head(model.degrees_of_freedom());
  const Vector rates = -model.trial().jerk.head(model.degrees_of_freedom()).cwiseProduct(model.masses());
  Vector rates_of_elements;
  const Vector of_elements = forces_of_elements(model, rates_of_elements);
  const double round_off = 1e-12 * of_elements.cwiseAbs().maxCoeff();
  ASSERT_GT(round_off, 0.0);
  EXPECT_LT((forces - of_elements).cwiseAbs().maxCoeff(), round_off);
  EXPECT_LT((rates - rates_of_elements.head(rates.size())).cwiseAbs().maxCoeff(),
            1e-12 * rates_of_elements.cwiseAbs().maxCoeff());
}

TEST(LinearPart, HasTheForcesOfItsElementsOnALine) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Model model = moat_model(random_model(seed));
    expect_forces_of_elements(model);
  }
}

TEST(LinearPart, HasTheForcesOfItsElementsInPlan) {
  Model model;
  add(model, with_eccentricity(
                 small_plan_building(
                     3, {.yield_force = 500 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 4 * MN / m}),
                 0.05, 0.04));
  expect_forces_of_elements(model);
}

Model two_springs() {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 2 * kg}), b = add(model, Node{.name = "b", .mass = 3 * kg});
  add(model,
      Spring{
          .name = "1", .lower = ground, .upper = a, .law = Linear{.stiffness = 100 * N / m, .damping = 5 * N * s / m}});
  add(model, Spring{.name = "2", .lower = a, .upper = b, .law = Linear{.stiffness = 50 * N / m}});
  return model;
}

TEST(LinearPart, LeavesNoResultOfItsElementsBehind) {
  Model model = two_springs();
  model.prepare();
  EXPECT_EQ(model.results(0).forces[0], 0.0);
  const auto move_to = [&](double of_a, double of_b, double speed) {
    MotionState& trial = model.trial();
    trial = model.state();
    trial.time += 0.1;
    trial.displacement.head(2) << of_a, of_b;
    trial.velocity.head(2) << speed, 0.0;
    trial.acceleration.head(2) << 2.0, 0.0;
    model.evaluate();
    model.evaluate_rates();
  };
  const auto expect = [&](double first, double first_rate, double second) {
    std::vector<double> forces, rates;
    for (std::size_t b = 0; b < model.blocks().size(); ++b) {
      const ElementResults results = model.results(b);
      forces.insert(forces.end(), results.forces.begin(), results.forces.end());
      rates.insert(rates.end(), results.force_rates.begin(), results.force_rates.end());
    }
    EXPECT_NEAR(forces.at(0), first, 1e-12);
    EXPECT_NEAR(rates.at(0), first_rate, 1e-12);
    EXPECT_NEAR(forces.at(1), second, 1e-12);
  };
  move_to(0.1, 0.3, 0.5);
  expect(10.0 + 2.5, 50.0 + 10.0, 10.0);
  // Asked for once, and again elsewhere.
  move_to(0.2, 0.2, 0.0);
  expect(20.0, 10.0, 0.0);
  model.commit();
  expect(20.0, 10.0, 0.0);
  // Not asked for before the commit; the velocity may be corrected there.
  move_to(0.3, 0.2, 0.0);
  model.trial().velocity[0] = 1.0;
  model.commit();
  expect(30.0 + 5.0, 100.0 + 10.0, -5.0);
  const Model copy = model;
  EXPECT_NEAR(copy.results(0).forces[0], 35.0, 1e-12);
}

}  // namespace
}  // namespace moat::testing
