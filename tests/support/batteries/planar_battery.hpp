// Tests that every law of two components must pass.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "materials/plan/planar_response.hpp"
#include "random_draws.hpp"

namespace moat::testing {

/// The sizes at which a law is tried.
struct PlanarTrial {
  double move = 0.02;  ///< m, the largest of a component
  double rate = 0.3;   ///< m/s, the largest of a component
  double force = 1e5;  ///< N, of its hysteresis
  bool dissipates = true;
  double energy = 1e-5;  ///< allowed error of the energy balance along short moves, over the work
  double pieces = 1e-9;  ///< allowed difference where a move is cut in pieces, over `force`; 0: not tried
  int pieces_of_work = 2000;

  /// s, of the largest move at the largest rate: its path is a cubic that bends.
  [[nodiscard]] double interval() const { return move / rate; }
};

/// Leads a law along moves, which are straight without an interval.
template <PlanarLaw Law>
struct PlanarPath {
  const Law& law;
  typename Law::State state{};
  PlanVector deformation{};

  PlanarResponse to(PlanVector target, PlanVector rate = {}, double interval = 0.0) {
    typename Law::State after;
    const PlanarResponse response = law.evaluate(state, target, rate, interval, after);
    state = after;
    deformation = target;
    return response;
  }
};

inline PlanVector random_vector(RandomDraws& draws, double size) {
  return {draws.uniform(-size, size), draws.uniform(-size, size)};
}

/// A path that is turned by any angle turns the force.
template <PlanarLaw Law>
void expect_turned_paths(const Law& law, const PlanarTrial& trial) {
  RandomDraws draws{7};
  for (int count = 0; count < 30; ++count) {
    const double a = draws.uniform(0.0, 6.3), c = std::cos(a), s = std::sin(a);
    const auto turn = [&](PlanVector v) { return PlanVector{c * v.x - s * v.y, s * v.x + c * v.y}; };
    PlanarPath<Law> plain{law}, turned{law};
    for (int i = 0; i < 20; ++i) {
      const PlanVector target = plain.deformation + random_vector(draws, trial.move);
      const PlanVector rate = random_vector(draws, trial.rate);
      const PlanVector expected = turn(plain.to(target, rate, trial.interval()).force),
                       force = turned.to(turn(target), turn(rate), trial.interval()).force;
      EXPECT_NEAR(force.x, expected.x, 1e-9 * trial.force);
      EXPECT_NEAR(force.y, expected.y, 1e-9 * trial.force);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

/// Both tangents against differences of the force, over paths that take this time, s, or are straight for zero. Places
/// beside a corner are left out; they must be few.
template <PlanarLaw Law>
void expect_planar_tangents(const Law& law, const PlanarTrial& trial, double interval) {
  RandomDraws draws{3};
  PlanarPath<Law> path{law};
  int tried = 0, beside_corners = 0;
  for (int i = 0; i < 400; ++i) {
    const PlanVector d = path.deformation + random_vector(draws, trial.move), v = random_vector(draws, trial.rate);
    typename Law::State ignored;
    const PlanarResponse at = law.evaluate(path.state, d, v, interval, ignored);
    const auto compare = [&](PlanVector by_d, PlanVector by_v, PlanVector tangent, double scale) {
      const auto force = [&](double x) {
        return law.evaluate(path.state, d + x * by_d, v + x * by_v, interval, ignored).force;
      };
      const PlanVector central = 0.5 * (force(1.0) - force(-1.0)), right = force(1.0) - at.force;
      ++tried;
      if (length(right - central) > 1e-3 * (length(central) + scale)) {
        ++beside_corners;
        return;
      }
      EXPECT_NEAR(central.x, tangent.x, 2e-5 * scale) << i;
      EXPECT_NEAR(central.y, tangent.y, 2e-5 * scale) << i;
    };
    const double width = 1e-6 * trial.move, faster = 1e-6 * trial.rate;
    const double stiffest = std::max({std::abs(at.stiffness.xx), std::abs(at.stiffness.yy), trial.force / trial.move}),
                 most_damped = std::max({std::abs(at.damping.xx), std::abs(at.damping.yy), trial.force / trial.rate});
    for (const PlanVector axis : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}}) {
      compare(width * axis, {}, width * (at.stiffness * axis), width * stiffest);
      compare({}, faster * axis, faster * (at.damping * axis), faster * most_damped);
    }
    if (::testing::Test::HasFailure()) return;
    path.to(d, v, interval);
  }
  EXPECT_LT(beside_corners, tried / 20);
}

/// The rate of the force while the motion goes on, without the part of the damping.
template <PlanarLaw Law>
void expect_force_rates(const Law& law, const PlanarTrial& trial) {
  RandomDraws draws{5};
  PlanarPath<Law> path{law};
  for (int i = 0; i < 200; ++i) {
    const PlanVector rate = random_vector(draws, trial.rate);
    const PlanarResponse at = path.to(path.deformation + random_vector(draws, trial.move), rate);
    typename Law::State ignored;
    const double h = 1e-6 * trial.move / trial.rate;
    const PlanVector after = law.evaluate(path.state, path.deformation + h * rate, rate, 0.0, ignored).force;
    const double scale = trial.rate * std::max(trial.force / trial.move, law.linear_stiffness(StiffnessStage::initial));
    EXPECT_NEAR((after.x - at.force.x) / h, at.force_rate.x, 1e-3 * scale) << i;
    EXPECT_NEAR((after.y - at.force.y) / h, at.force_rate.y, 1e-3 * scale) << i;
    if (::testing::Test::HasFailure()) return;
  }
}

/// A straight move in a hundred pieces ends at the same force. At one speed.
template <PlanarLaw Law>
void expect_independence_of_pieces(const Law& law, const PlanarTrial& trial) {
  RandomDraws draws{11};
  PlanarPath<Law> path{law};
  const PlanVector rate{trial.rate, 0.0};
  for (int i = 0; i < 60; ++i) {
    const PlanVector from = path.deformation, target = from + random_vector(draws, trial.move);
    PlanarPath<Law> divided = path;
    constexpr int parts = 100;
    PlanVector force;
    for (int k = 1; k <= parts; ++k) force = divided.to(from + double(k) / parts * (target - from), rate).force;
    const PlanVector whole = path.to(target, rate).force;
    EXPECT_NEAR(force.x, whole.x, trial.pieces * trial.force) << i;
    EXPECT_NEAR(force.y, whole.y, trial.pieces * trial.force) << i;
    if (::testing::Test::HasFailure()) return;
  }
}

/// Work = stored + dissipated along random moves in short pieces.
template <PlanarLaw Law>
void expect_energy_balance(const Law& law, const PlanarTrial& trial) {
  RandomDraws draws{13};
  PlanarPath<Law> path{law};
  const PlanVector rate{trial.rate, 0.0};
  double work = 0.0, scale = 0.0;
  PlanVector force;
  for (int i = 0; i < 50; ++i) {
    const PlanVector from = path.deformation, target = from + random_vector(draws, trial.move);
    for (int k = 1; k <= trial.pieces_of_work; ++k) {
      const PlanVector before = path.deformation;
      [[maybe_unused]] const typename Law::State at_start = path.state;
      const PlanVector after = path.to(from + double(k) / trial.pieces_of_work * (target - from), rate).force;
      work += dot(0.5 * (force + after), path.deformation - before);
      if constexpr (GivesWeightWork<Law, PlanVector>)
        work += law.weight_work(at_start, before, path.state, path.deformation);
      force = after;
    }
    scale = std::max(scale, std::abs(work));
  }
  const double dissipated = law.dissipated_energy({}, path.state);
  if (trial.dissipates)
    EXPECT_GT(dissipated, 0.1 * work);
  else
    EXPECT_EQ(dissipated, 0.0);
  EXPECT_NEAR(work, law.stored_energy(path.state, path.deformation) + dissipated, trial.energy * scale);
}

/// The same arguments give the same bits for every former content of the trial state.
template <PlanarLaw Law>
void expect_planar_purity(const Law& law, const PlanarTrial& trial) {
  RandomDraws draws{17};
  PlanarPath<Law> path{law};
  const auto bits = [](PlanVector v) {
    return std::pair{std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y)};
  };
  for (int i = 0; i < 100; ++i) {
    const PlanVector d = path.deformation + random_vector(draws, trial.move), v = random_vector(draws, trial.rate);
    const typename Law::State before = path.state;
    typename Law::State first{}, second = before;
    const PlanarResponse one = law.evaluate(path.state, d, v, trial.interval(), first),
                         two = law.evaluate(path.state, d, v, trial.interval(), second);
    EXPECT_EQ(bits(one.force), bits(two.force));
    EXPECT_TRUE(one.stiffness == two.stiffness && one.damping == two.damping);
    EXPECT_TRUE(first == second);
    EXPECT_TRUE(before == path.state);
    path.to(d, v, trial.interval());
  }
}

template <PlanarLaw Law>
void expect_sound_planar_law(const Law& law, const PlanarTrial& trial) {
  expect_turned_paths(law, trial);
  for (const double interval : {0.0, trial.interval()}) expect_planar_tangents(law, trial, interval);
  expect_force_rates(law, trial);
  if (trial.pieces > 0.0) expect_independence_of_pieces(law, trial);
  expect_energy_balance(law, trial);
  expect_planar_purity(law, trial);
}

}  // namespace moat::testing
