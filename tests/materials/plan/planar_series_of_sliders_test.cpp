// Double and triple pendulums in plan: circles and corners of closed form, straight paths, changing weight.
#include "materials/plan/planar_series_of_sliders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "message_of.hpp"
#include "random_draws.hpp"

namespace moat::testing {
namespace {

using namespace units;

struct Path {
  PlanarSeriesOfSliders law;
  double weight = law.static_weight;
  PlanarSeriesOfSliders::State state{};
  PlanVector deformation{};
  PlanarAxialResponse response{};

  void to(PlanVector target, PlanVector rate = {}) {
    PlanarSeriesOfSliders::State after;
    response = law.evaluate(state, target, rate, 0.0, {weight}, after);
    state = after;
    deformation = target;
  }
  void along(PlanVector target, int steps) {
    const PlanVector from = deformation;
    for (int i = 1; i <= steps; ++i) to(from + double(i) / steps * (target - from));
  }
  [[nodiscard]] PlanVector slip(std::size_t i) const {
    return state.sliders[i].displacement - state.sliders[i].friction_force / law.line.elastic_stiffness;
  }
};

PlanarSeriesOfSliders double_pendulum() { return in_plan_under_changing_weight(DoublePendulum::typical(), 1 * MN); }
PlanarSeriesOfSliders triple_pendulum() {
  return in_plan_under_changing_weight(TriplePendulum::typical(), 13.345 * MN);
}
// Both inner surfaces at different stops.
PlanarSeriesOfSliders unequal_pendulum() {
  TriplePendulum design = TriplePendulum::typical();
  design.lower_radius = 5 * m;
  design.upper_radius = 2.5 * m;
  return in_plan_under_changing_weight(design, 1 * MN);
}

// A steady circle: slips of the radius r_i that turn with the angle a_i, s_i = r_i e^(i a_i), so
//
//     F = (k_i r_i + i (1 + k_i/k_e) f_i) e^(i a_i),   u_i = s_i + i f_i/k_e e^(i a_i)
//
// or u_i = F/(k_i + k_e) where it sticks. |F| follows from |sum u_i| by bisection.
struct SteadyCircle {
  double force = 0.0, along = 0.0, ahead = 0.0, heat = 0.0;  // heat of a turn, J
  std::array<double, 3> slips{};

  SteadyCircle(const SeriesOfSliders& line, double radius) {
    double low = 0.0, high = 1e9;
    for (int i = 0; i < 200; ++i) {
      force = 0.5 * (low + high);
      // Displacements along the force and behind it.
      double u = 0.0, behind = 0.0;
      heat = 0.0;
      for (std::size_t k = 0; k < line.count; ++k) {
        const auto& [stiffness, friction, capacity, first_stop] = line.branches[k];
        const double least = (1.0 + stiffness / line.elastic_stiffness) * friction;
        if (force <= least) {
          u += force / (stiffness + line.elastic_stiffness);
          slips[k] = 0.0;
          continue;
        }
        slips[k] = std::sqrt(force * force - least * least) / stiffness;
        const double c = stiffness * slips[k] / force, s = least / force, stretch = friction / line.elastic_stiffness;
        u += c * slips[k] + s * stretch;
        behind += s * slips[k] - c * stretch;
        heat += 2.0 * std::numbers::pi * friction * slips[k];
      }
      along = force * u / std::hypot(u, behind);
      ahead = force * behind / std::hypot(u, behind);
      (std::hypot(u, behind) < radius ? low : high) = force;
    }
  }
};

struct Turned {
  Path path;
  double heat;
};
Turned turn(const PlanarSeriesOfSliders& law, double radius, int steps) {
  Path path{law};
  path.along({radius, 0.0}, 50);
  double before = 0.0;
  constexpr int turns = 3;
  for (int i = 1; i <= turns * steps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / steps;
    path.to({radius * std::cos(angle), radius * std::sin(angle)});
    if (i == (turns - 1) * steps) before = path.state.heat;
  }
  return {path, path.state.heat - before};
}

TEST(PlanarSeriesOfSliders, TurnsInACircleOfClosedForm) {
  struct Case {
    PlanarSeriesOfSliders law;
    double radius, force, along, ahead, heat;
    std::array<double, 3> slips;
  };
  for (const Case& each :
       {Case{double_pendulum(), 0.2, 78198.063, 63815.409, 45194.366, 56792.916, {0.144220312, 0.067318055, 0.0}},
        Case{double_pendulum(), 0.05, 39110.263, 25390.164, 29748.147, 9345.656, {0.049580245, 0.0, 0.0}},
        Case{triple_pendulum(),
             0.6,
             1389531.43,
             1202520.87,
             696233.55,
             2624738.66,
             {0.081575207, 0.321760213, 0.220211989}}}) {
    const SteadyCircle exact{each.law.line, each.radius};
    EXPECT_NEAR(exact.force / each.force, 1.0, 1e-8);
    EXPECT_NEAR(exact.along / each.along, 1.0, 1e-8);
    EXPECT_NEAR(exact.ahead / each.ahead, 1.0, 1e-8);
    EXPECT_NEAR(exact.heat / each.heat, 1.0, 1e-7);
    std::vector<double> errors;
    for (const int steps : {1600, 3200}) {
      const auto [path, heat] = turn(each.law, each.radius, steps);
      const PlanVector force = path.response.force;
      errors.push_back(length(force - PlanVector{exact.along, exact.ahead}));
      EXPECT_NEAR(heat / exact.heat, 1.0, 8e-5);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(exact.slips[i], each.slips[i], 1e-8);
        EXPECT_NEAR(length(path.slip(i)), exact.slips[i], 2e-4 * exact.slips[0]);
      }
    }
    // Of second order.
    EXPECT_LT(errors[1], 4e-5 * exact.force);
    EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.3);
  }
}

TEST(PlanarSeriesOfSliders, FollowsACorner) {
  struct Case {
    PlanarSeriesOfSliders law;
    double way;
    PlanVector force;
    double heat;
  };
  for (const Case& each : {Case{double_pendulum(), 0.2, {59042.987, 71876.866}, 11904.504},
                           Case{triple_pendulum(), 0.6, {1172607.06, 1232934.55}, 545320.6}}) {
    Path path{each.law};
    path.along({each.way, 0.0}, 2000);
    path.along({each.way, 0.5 * each.way}, 2000);
    EXPECT_LT(length(path.response.force - each.force), 1e-6 * length(each.force));
    EXPECT_NEAR(path.state.heat / each.heat, 1.0, 4e-6);
  }
}

// Random moves on a straight line, up to all stops.
TEST(PlanarSeriesOfSliders, IsTheLawOfALineOnAStraightPath) {
  for (const PlanarSeriesOfSliders& law : {double_pendulum(), triple_pendulum(), unequal_pendulum()}) {
    RandomDraws draws{5};
    const double angle = draws.uniform(0.0, 6.0);
    const PlanVector way{std::cos(angle), std::sin(angle)};
    Path path{law};
    SeriesOfSliders::State on_line, after;
    for (int i = 0; i < 2000; ++i) {
      const double target =
          draws.uniform(-1.1, 1.1) * (i % 7 == 0 ? 1.0 : 1e-2) + (i % 7 == 0 ? 0.0 : on_line.deformation);
      if (std::abs(target) > 1.15) continue;
      const Response line = law.line.evaluate(on_line, target, 1.0, after);
      path.to(target * way, way);
      on_line = after;
      EXPECT_LT(length(path.response.force - line.force * way), 1e-10 * law.static_weight) << i;
      EXPECT_NEAR(dot(way, path.response.stiffness * way), line.stiffness, 1e-6 * line.stiffness) << i;
    }
  }
}

TEST(PlanarSeriesOfSliders, TurnsWithItsPath) {
  for (const PlanarSeriesOfSliders& law : {double_pendulum(), unequal_pendulum()}) {
    RandomDraws draws{11};
    const double a = 0.7, c = std::cos(a), s = std::sin(a);
    const auto turned = [&](PlanVector v) { return PlanVector{c * v.x - s * v.y, s * v.x + c * v.y}; };
    Path plain{law}, other{law};
    for (int i = 0; i < 300; ++i) {
      const PlanVector target{draws.uniform(-0.3, 0.3), draws.uniform(-0.3, 0.3)};
      plain.weight = other.weight = draws.uniform(0.2, 2.0) * law.static_weight;
      plain.to(target);
      other.to(turned(target));
      EXPECT_LT(length(turned(plain.response.force) - other.response.force), 1e-12 * law.static_weight) << i;
    }
  }
}

// By differences, in small and in large moves, some of which are cut in pieces.
TEST(PlanarSeriesOfSliders, HasExactTangentsUnderAChangingWeight) {
  for (const PlanarSeriesOfSliders& law : {double_pendulum(), triple_pendulum(), unequal_pendulum()})
    for (const double size : {5e-4, 0.05}) {
      RandomDraws draws{17};
      const double w = law.static_weight;
      Path path{law};
      int beside_corners = 0;
      for (int i = 0; i < 200; ++i) {
        const PlanVector d =
            0.99 * path.deformation + PlanVector{draws.uniform(-size, size), draws.uniform(-size, size)};
        const double weight = draws.uniform(0.2, 2.0) * w, width = 1e-7, heavier = 1e-6 * w;
        PlanarSeriesOfSliders::State ignored;
        const auto at = law.evaluate(path.state, d, {}, 0.0, {weight}, ignored);
        const auto compare = [&](PlanVector move, double change, PlanVector tangent, double scale) {
          const auto force = [&](double x) {
            return law.evaluate(path.state, d + x * move, {}, 0.0, {weight + x * change}, ignored).force;
          };
          const PlanVector central = 0.5 * (force(1.0) - force(-1.0));
          if (length(force(1.0) - at.force - central) > 1e-3 * (length(central) + scale))
            ++beside_corners;
          else
            EXPECT_LT(length(central - tangent), 1e-5 * scale) << i;
        };
        const double stiffest = law.linear_stiffness(StiffnessStage::initial);
        for (const PlanVector axis : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
          compare(width * axis, 0.0, width * (at.stiffness * axis), width * stiffest);
        compare({}, heavier, heavier * at.by_compression, heavier);
        path.weight = weight;
        path.to(d);
      }
      EXPECT_LT(beside_corners, 20);
    }
}

// Without the springs of the stops, whose work a mean force does not integrate; it lifts now and then.
TEST(PlanarSeriesOfSliders, BalancesItsEnergyUnderAChangingWeight) {
  for (const PlanarSeriesOfSliders& law : {double_pendulum(), triple_pendulum()}) {
    RandomDraws draws{23};
    Path path{law};
    double scale = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const Path before = path;
      path.weight = std::max(draws.uniform(-0.2, 2.0), 0.0) * law.static_weight;
      path.to({draws.uniform(-0.15, 0.15), draws.uniform(-0.15, 0.15)});
      if (path.weight == 0.0) {
        EXPECT_EQ(path.response.force, PlanVector{});
      }
      const double work =
          dot(0.5 * (before.response.force + path.response.force), path.deformation - before.deformation);
      const double of_weight = (path.state.compression - before.state.compression) *
                               law.weight_lever(before.state, before.deformation, path.state, path.deformation);
      const double stored =
          law.stored_energy(path.state, path.deformation) - law.stored_energy(before.state, before.deformation);
      scale = std::max(scale, std::abs(work));
      EXPECT_NEAR(work, stored - of_weight + law.dissipated_energy(before.state, path.state), 1e-9 * scale) << i;
    }
    EXPECT_GT(path.state.heat, 0.0);
  }
}

TEST(PlanarSeriesOfSliders, RefusesBadParameters) {
  DoublePendulum design = DoublePendulum::typical();
  design.second_friction = 0.4;
  EXPECT_NE(message_of([&] { in_plan(design, 1 * MN); }).find("second_friction"), std::string::npos);
  const auto weightless = in_plan(DoublePendulum::typical(), 0 * N);
  EXPECT_NE(message_of([&] { weightless.check(Check{"PlanarSpring", "bearing"}); }).find("weight"), std::string::npos);
}

}  // namespace
}  // namespace moat::testing
