// Double and triple pendulums on a line under a weight that changes.
#include "materials/series_under_weight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/carrying.hpp"
#include "materials/isolation/double_pendulum.hpp"
#include "materials/isolation/triple_pendulum.hpp"
#include "materials/plan/planar_series_of_sliders.hpp"
#include "random_draws.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;
static_assert(AxialForceLaw<SeriesUnderWeight> && LawWithRegimes<Carrying<SeriesUnderWeight>>);

TriplePendulum unequal_triple() {
  TriplePendulum design = TriplePendulum::typical();
  design.lower_radius = 5 * m;
  design.upper_radius = 2.5 * m;
  return design;
}

struct Path {
  SeriesUnderWeight law;
  SeriesUnderWeight::State state{};
  Response response{};

  void to(double target, double weight) {
    SeriesUnderWeight::State after;
    response = law.evaluate(state, target, 1.0, {}, {weight}, after);
    state = after;
  }
};

TEST(SeriesUnderWeight, PassesTheBatteryUnderAConstantWeight) {
  expect_sound_spring(Carrying<SeriesUnderWeight>{unequal_triple().under_changing_weight(20 * MN), 30e6},
                      {.deformation = 1.152, .energy = 1e-8, .panels = 8, .moves = 8});
}

// Located changes included.
TEST(SeriesUnderWeight, IsTheLawOfAConstantWeight) {
  const SpringTrial trial{.deformation = 1.1};
  for (const double share : {1.0, 0.7}) {
    const double weight = share * 30e6;
    const Carrying<SeriesUnderWeight> law{unequal_triple().under_changing_weight(30 * MN), weight};
    LawPath<Carrying<SeriesUnderWeight>> path{law, 0};
    SeriesOfSliders line = unequal_triple().carrying(weight * N);
    line.elastic_stiffness = law.law.line.elastic_stiffness;
    line.stop_stiffness = law.law.line.stop_stiffness;
    LawPath<SeriesOfSliders> plain{line, 0};
    RandomMoves moves{trial};
    for (int i = 0; i < 300; ++i) {
      const double target = moves.target(path.deformation());
      path.move(target, 1.0);
      plain.move(target, 1.0);
      EXPECT_NEAR(path.force(), plain.force(), 1e-12 * weight) << i;
    }
    EXPECT_NEAR(path.dissipated(), plain.dissipated(), 1e-6 * plain.dissipated());
  }
}

// A slider that sticks keeps its force until the limit falls below it, and does not get it back.
TEST(SeriesUnderWeight, ShedsItsFriction) {
  // Two sliders of which the second never slides; the first is a pendulum with k_0 = k_e.
  DoublePendulum design = DoublePendulum::typical();
  Path path{design.under_changing_weight(1 * MN)};
  const double elastic = path.law.line.elastic_stiffness, k = 1e6 / 2.0;
  const double force = 0.5 * (elastic + k) * 0.8e-3;  // both move alike
  path.to(0.8e-3, 1e6);
  EXPECT_NEAR(path.response.force, force, 1e-9 * force);
  const double friction = elastic * 0.4e-3;
  ASSERT_LT(friction, 0.03 * 1e6);
  // To 60 % at rest: the limit 18 kN is below the friction of the first slider, 24 kN.
  path.to(0.8e-3, 0.6e6);
  EXPECT_NEAR(elastic * (path.state.displacements[0] - path.state.sliders.slips[0]), 18e3, 1e-6);
  const double after_fall = path.response.force;
  EXPECT_LT(after_fall, force);
  const double slip = path.state.sliders.slips[0];
  path.to(0.8e-3, 1e6);
  EXPECT_NEAR(path.state.sliders.slips[0], slip, 1e-15);
}

TEST(SeriesUnderWeight, HasExactTangents) {
  for (const SeriesUnderWeight& law :
       {DoublePendulum::typical().under_changing_weight(1 * MN), unequal_triple().under_changing_weight(1 * MN)}) {
    RandomDraws draws{41};
    Path path{law};
    int beside_corners = 0;
    for (int i = 0; i < 1000; ++i) {
      const double size = i % 3 == 0 ? 0.3 : 1e-3,
                   d = 0.98 * path.state.sliders.deformation + draws.uniform(-size, size),
                   weight = draws.uniform(0.005, 2.0) * 1e6;
      SeriesUnderWeight::State ignored;
      const auto force = [&](double at, double n) { return law.evaluate(path.state, at, 1.0, {}, {n}, ignored).force; };
      path.law.evaluate(path.state, d, 1.0, {}, {weight}, ignored);
      const Response here = law.evaluate(path.state, d, 1.0, {}, {weight}, ignored);
      const auto compare = [&](double move, double change, double tangent, double scale) {
        const double right = force(d + move, weight + change) - here.force,
                     central = 0.5 * (force(d + move, weight + change) - force(d - move, weight - change));
        if (std::abs(right - central) > 1e-4 * scale)
          ++beside_corners;
        else
          EXPECT_NEAR(central, tangent, 2e-4 * scale) << i;
      };
      compare(1e-8, 0.0, 1e-8 * here.stiffness, 1e-8 * here.stiffness);
      compare(0.0, 1e-2, 1e-2 * here.by_compression, 1e-2 * 0.1);
      path.to(d, weight);
    }
    EXPECT_LT(beside_corners, 40);
  }
}

// The springs of the stops are left out: a mean force does not integrate their work.
TEST(SeriesUnderWeight, BalancesItsEnergy) {
  RandomDraws draws{43};
  Path path{DoublePendulum::typical().under_changing_weight(1 * MN)};
  double scale = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Path before = path;
    const double d = draws.uniform(-0.3, 0.3), weight = std::max(draws.uniform(-0.2, 2.0), 0.0) * 1e6,
                 from = before.state.sliders.deformation;
    path.to(d, weight);
    if (weight == 0.0) {
      EXPECT_EQ(path.response.force, 0.0);
    }
    const double work = 0.5 * (before.response.force + path.response.force) * (d - from),
                 of_weight =
                     (weight - before.state.compression) * path.law.weight_lever(before.state, from, path.state, d),
                 stored = path.law.stored_energy(path.state, d) - path.law.stored_energy(before.state, from);
    scale = std::max(scale, std::abs(work));
    EXPECT_NEAR(work, stored - of_weight + path.law.dissipated_energy(before.state, path.state), 1e-9 * scale) << i;
  }
}

// The law in plan on a straight path, to the stops, under the same weight.
TEST(SeriesUnderWeight, IsTheLawInPlanOnAStraightPath) {
  RandomDraws draws{47};
  Path path{unequal_triple().under_changing_weight(1 * MN)};
  const PlanarSeriesOfSliders in_plan = in_plan_under_changing_weight(unequal_triple(), 1 * MN);
  PlanarSeriesOfSliders::State state, after;
  const PlanVector way{0.6, 0.8};
  for (int i = 0; i < 1000; ++i) {
    const double size = i % 5 == 0 ? 0.5 : 2e-3, d = 0.98 * path.state.sliders.deformation + draws.uniform(-size, size),
                 weight = draws.uniform(-0.1, 2.0) * 1e6;
    path.to(d, weight);
    const auto response = in_plan.evaluate(state, d * way, way, 0.0, {weight}, after);
    state = after;
    EXPECT_LT(length(response.force - path.response.force * way), 1e-10 * 1e6) << i;
    EXPECT_NEAR(dot(way, response.by_compression), path.response.by_compression, 1e-6) << i;
  }
}

// A limit that rises with N carries the corner along: the first slider begins at d = 2 mu_1 N/(k + k_e).
TEST(SeriesUnderWeight, FindsACornerThatMoves) {
  const SeriesUnderWeight law = DoublePendulum::typical().under_changing_weight(1 * MN);
  SeriesUnderWeight::State state;
  law.evaluate({}, 1e-5, 1.0, {}, {1e6}, state);
  for (const double weight : {0.8e6, 1e6, 1.3e6}) {
    const double k = weight / 2.0, elastic = law.line.elastic_stiffness,
                 corner = 2.0 * 0.03 * weight / elastic * (k + elastic) / (k + elastic);
    SeriesUnderWeight::State there;
    law.evaluate(state, 0.5 * corner, 1.0, {}, {weight}, there);
    EXPECT_NEAR(law.regime_margin(there, 0.5 * corner, 1.0), 0.5 * corner, 2e-10) << weight;
  }
}

// A corner that the end of a step has passed lies behind the state there, until the next regime begins: with the slips
// of the end its margin would be that of the start, and the step would be cut at it again and again.
TEST(SeriesUnderWeight, PassesTheCornersThatItReaches) {
  for (const SeriesUnderWeight& law :
       {DoublePendulum::typical().under_changing_weight(1 * MN), unequal_triple().under_changing_weight(1 * MN)})
    for (const double fall : {0.0, -1e5}) {
      Path path{law};
      path.to(0.0, 1e6);
      path.to(1e-5, 1e6);
      for (std::size_t corner = 0; corner < law.line.count; ++corner) {
        const double before = path.state.sliders.deformation;
        double beyond = 0.5;  // m
        for (double part = beyond; part > 1e-14; part *= 0.5) {
          Path trial = path;
          trial.to(before + beyond - part, 1e6 + fall * (beyond - part));
          if (law.regime_margin(trial.state, before + beyond - part, 1.0) < 0.0) beyond -= part;
        }
        path.to(before + beyond, 1e6 + fall * beyond);
        const double d = path.state.sliders.deformation;
        EXPECT_LT(law.regime_margin(path.state, d, 1.0), 0.0);
        path.state = law.next_regime(path.state, d, 1.0);
        EXPECT_GT(law.regime_margin(path.state, d, 1.0), 1e-6);
      }
    }
}

// Friction on its limit follows the limit while the slider moves back more slowly than it falls.
TEST(SeriesUnderWeight, FollowsAFallingLimitWhileItMovesBack) {
  Path path{DoublePendulum::typical().under_changing_weight(1 * MN)};
  const double elastic = path.law.line.elastic_stiffness;
  path.to(0.01, 1e6);
  for (int i = 1; i <= 20; ++i) {
    const double weight = 1e6 - 2e4 * i;
    path.to(0.01 - 1e-6 * i, weight);
    EXPECT_NEAR(elastic * (path.state.displacements[0] - path.state.sliders.slips[0]), 0.03 * weight, 1e-9 * weight);
  }
}

TEST(SeriesUnderWeight, KeepsItsForceAtAnInstantEvaluatedAgain) {
  RandomDraws draws{53};
  Path path{unequal_triple().under_changing_weight(1 * MN)};
  for (int i = 0; i < 500; ++i) {
    const double weight = i % 2 == 0 ? draws.uniform(0.0, 0.012) * 1e6 : draws.uniform(-0.1, 1.5) * 1e6,
                 d = draws.uniform(-0.3, 0.3);
    path.to(d, weight);
    const double force = path.response.force;
    const SeriesUnderWeight::State state = path.state;
    path.to(d, weight);
    EXPECT_NEAR(path.response.force, force, 1e-10 * 1e6) << i;
    EXPECT_EQ(path.state, state) << i;
  }
}

// The rate is that of the force on the way on, with the friction that a falling weight sheds.
TEST(SeriesUnderWeight, HasTheRateOfItsForce) {
  for (const SeriesUnderWeight& law :
       {DoublePendulum::typical().under_changing_weight(1 * MN), unequal_triple().under_changing_weight(1 * MN)}) {
    RandomDraws draws{59};
    Path path{law};
    int beside_corners = 0, sheds = 0;
    for (int i = 0; i < 1000; ++i) {
      const double size = i % 3 == 0 ? 0.3 : 1e-3,
                   d = 0.98 * path.state.sliders.deformation + draws.uniform(-size, size),
                   weight = draws.uniform(0.005, 2.0) * 1e6;
      path.to(d, weight);
      const double rate = draws.uniform(-0.05, 0.05), weight_rate = draws.uniform(-1.0, 1.0) * 1e8, time = 1e-8;
      Path on = path;
      on.to(d + rate * time, weight + weight_rate * time);
      const double difference = (on.response.force - path.response.force) / time,
                   expected = law.force_rate(path.state, d, rate, 0.0, weight_rate),
                   scale = 1e8 * 0.1 + std::abs(rate) * law.line.elastic_stiffness;
      if (std::abs(difference - expected) > 1e-4 * scale) ++beside_corners;
      sheds += weight_rate < 0.0 && path.state.yields[0] && path.state.yields[1];
    }
    EXPECT_LT(beside_corners, 20);
    EXPECT_GT(sheds, 50);
  }
}

}  // namespace
}  // namespace moat::testing
