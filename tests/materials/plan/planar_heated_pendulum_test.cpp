// Friction pendulum that heats, in plan: the law of a line on straight paths, and its own properties.
#include "materials/plan/planar_heated_pendulum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "message_of.hpp"
#include "random_draws.hpp"

namespace moat::testing {
namespace {

using namespace units;

PlanarHeatedPendulum pendulum(Length radius_of_contact = 20 * cm) {
  HeatedFrictionPendulum design = HeatedFrictionPendulum::typical();
  design.friction = PressureTemperatureVelocity{
      .reference_coefficient = 0.06, .reference_pressure = 20 * MN / (m * m), .slider_radius = radius_of_contact};
  return in_plan_under_changing_weight(design, 1 * MN);
}

// Both laws along d = a sin(w t) + b sin(2 w t), in steps that end where the law on a line changes its regime.
TEST(PlanarHeatedPendulum, IsTheLawOfALineOnAStraightPath) {
  for (const Length contact : {40 * cm, 5 * cm}) {
    const PlanarHeatedPendulum law = pendulum(contact);
    const HeatedSlidingIsolator& line = law.line;
    const PlanVector way{0.6, -0.8};
    const auto at = [](double t) { return 0.15 * std::sin(3.0 * t) + 0.05 * std::sin(6.0 * t); };
    const auto rate = [](double t) { return 0.45 * std::cos(3.0 * t) + 0.30 * std::cos(6.0 * t); };
    HeatedSlidingIsolator::State on_line, after_line;
    PlanarHeatedPendulum::State in_plan, after;
    double time = 0.0, heat = 0.0;
    int changes = 0;
    const auto margin = [&](double t) { return line.regime_margin(on_line, at(t), rate(t)); };
    for (int step = 1; step <= 800; ++step) {
      while (true) {
        double end = 0.01 * step;
        const bool change = margin(end) < 0.0;
        if (change)
          for (double before = time, middle = 0.5 * (before + end); middle > before && middle < end;
               middle = 0.5 * (before + end))
            (margin(middle) < 0.0 ? end : before) = middle;
        const Response expected =
            line.evaluate(on_line, at(end), rate(end), {end - time, at(time), rate(time)}, after_line);
        const auto response = law.evaluate(in_plan, at(end) * way, rate(end) * way, end - time, {1e6}, after);
        EXPECT_LT(length(response.force - expected.force * way), 1e-10 * 1e6) << end;
        heat += line.dissipated_energy(on_line, after_line);
        in_plan = after;
        on_line = after_line;
        time = end;
        if (!change) {
          EXPECT_NEAR(in_plan.surface.rise, on_line.rise, 1e-7 * on_line.rise) << time;
          break;
        }
        ++changes;
        const double stored = line.stored_energy(on_line, at(time));
        on_line = line.next_regime(on_line, at(time), rate(time));
        heat += stored - line.stored_energy(on_line, at(time));
        ASSERT_LT(changes, 200);
      }
    }
    EXPECT_GT(on_line.rise, 5.0);
    EXPECT_GT(changes, 12);
    EXPECT_NEAR(in_plan.heat, heat, 1e-3 * heat);
  }
}

// A steady circle of the radius r over the centre. Slip turns with it on a circle of the radius r_s, and friction of
// the size f is perpendicular to it: d = (r_s + i f/k_0) e^(i a), q = i f e^(i a). A constant flux q heats a half-space
// by 2 q sqrt(D t/pi)/k.
TEST(PlanarHeatedPendulum, TurnsAndHeatsInACircleOfClosedForm) {
  PlanarHeatedPendulum law = pendulum();
  law.line.friction.weakening = PressureTemperatureVelocity::Weakening::none;
  constexpr double radius = 0.1, turns = 2.0, time = 4.0, w = 2.0 * std::numbers::pi * turns / time, speed = radius * w;
  const double friction = law.line.limit({}, speed), per_weight = friction / law.line.normal_force,
               stretch = friction / law.line.elastic_stiffness, slip = std::sqrt(radius * radius - stretch * stretch);
  const PlanVector exact{law.line.restoring_stiffness * radius + friction * stretch / radius, friction * slip / radius};
  for (const int steps : {400, 1600}) {
    PlanarHeatedPendulum::State state, next;
    PlanarAxialResponse response;
    for (int i = 0; i <= steps; ++i) {
      const double h = time / steps;
      const PlanVector along{std::cos(w * h * i), std::sin(w * h * i)};
      response = law.evaluate(state, radius * along, speed * turned_left(along), i == 0 ? 0.0 : h, {1e6}, next);
      state = next;
    }
    // Of fourth order in the step.
    EXPECT_LT(length(response.force - exact), (steps == 400 ? 2e-3 : 1e-5) * friction);
    const double rise =
        law.line.friction.heating_factor() * 2.0 * per_weight * law.line.pressure() * speed * std::sqrt(time);
    EXPECT_NEAR(state.surface.rise, rise, 3e-3 * rise) << steps;
  }
}

// By differences, under a changing weight, in steps that pass the edge of the contact too.
TEST(PlanarHeatedPendulum, HasExactTangentsUnderAChangingWeight) {
  const PlanarHeatedPendulum law = pendulum(5 * cm);
  RandomDraws draws{31};
  PlanarHeatedPendulum::State state, next;
  int beside_corners = 0, slides = 0;
  for (int i = 0; i < 600; ++i) {
    const PlanVector d = 0.95 * state.deformation + PlanVector{draws.uniform(-0.01, 0.01), draws.uniform(-0.01, 0.01)},
                     v{draws.uniform(-0.3, 0.3), draws.uniform(-0.3, 0.3)};
    const double weight = draws.uniform(0.3, 2.0) * 1e6;
    const auto at = law.evaluate(state, d, v, 0.02, {weight}, next);
    slides += next.slides;
    const auto compare = [&](PlanVector move, PlanVector faster, double change, PlanVector tangent, double scale) {
      PlanarHeatedPendulum::State ignored;
      const auto force = [&](double x) {
        return law.evaluate(state, d + x * move, v + x * faster, 0.02, {weight + x * change}, ignored).force;
      };
      const PlanVector central = 0.5 * (force(1.0) - force(-1.0));
      if (length(force(1.0) - at.force - central) > 1e-3 * (length(central) + scale))
        ++beside_corners;
      else
        EXPECT_LT(length(central - tangent), 1e-4 * scale) << i;
    };
    for (const PlanVector axis : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}}) {
      compare(1e-7 * axis, {}, 0.0, 1e-7 * (at.stiffness * axis), 1e-7 * 6e7);
      compare({}, 1e-6 * axis, 0.0, 1e-6 * (at.damping * axis), 1e-6 * 1e5);
    }
    compare({}, {}, 1.0, at.by_compression, 0.1);
    state = next;
  }
  EXPECT_LT(beside_corners, 60);
  EXPECT_GT(slides, 200);
}

TEST(PlanarHeatedPendulum, BalancesItsEnergyUnderAChangingWeight) {
  const PlanarHeatedPendulum law = pendulum();
  RandomDraws draws{37};
  PlanarHeatedPendulum::State state, next;
  PlanVector force;
  double scale = 0.0;
  for (int i = 0; i < 500; ++i) {
    const PlanVector d{draws.uniform(-0.1, 0.1), draws.uniform(-0.1, 0.1)};
    const double weight = std::max(draws.uniform(-0.2, 2.0), 0.0) * 1e6;
    const auto response = law.evaluate(state, d, {0.1, 0.2}, 0.01, {weight}, next);
    if (weight == 0.0) {
      EXPECT_EQ(response.force, PlanVector{});
    }
    const double work = dot(0.5 * (force + response.force), d - state.deformation);
    const double of_weight =
        (next.compression - state.compression) * law.weight_lever(state, state.deformation, next, d);
    const double stored = law.stored_energy(next, d) - law.stored_energy(state, state.deformation);
    scale = std::max(scale, std::abs(work));
    EXPECT_NEAR(work, stored - of_weight + law.dissipated_energy(state, next), 1e-12 * scale) << i;
    state = next;
    force = response.force;
  }
  EXPECT_GT(state.heat, 0.0);
}

TEST(PlanarHeatedPendulum, RefusesBadParameters) {
  HeatedFrictionPendulum design = HeatedFrictionPendulum::typical();
  design.yield_displacement = 0 * m;
  EXPECT_NE(message_of([&] { in_plan(design, 1 * MN); }).find("yield_displacement"), std::string::npos);
  const auto weightless = in_plan(HeatedFrictionPendulum::typical(), 0 * N);
  EXPECT_NE(message_of([&] { weightless.check(Check{"PlanarSpring", "bearing"}); }).find("weight"), std::string::npos);
}

}  // namespace
}  // namespace moat::testing
