// Buildings on rubber bearings that soften under overturning, against a program of this test, and their events.
#include "elements/line/softening_rubber.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "moat.hpp"
#include "peak_in.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double gravity = 9.80665;  // m/s^2
constexpr double k_20 = 2.4e6, yield_force = 264e3, yield_displacement = 0.01;
constexpr double critical_at_rest = 24.2422641e6;  // N

SofteningRubber bearing() {
  return {
      .bearing = LeadRubberBearing{.yield_force = yield_force * N,
                                   .yield_displacement = yield_displacement * m,
                                   .post_yield_stiffness = k_20 * N / m},
      .rubber = {
          .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 180 * mm, .shear_modulus = 0.5 * MPa}};
}

GroundMotion horizontal(double size = 1.9) {
  std::vector<double> samples;
  for (int i = 0; i <= 300; ++i) samples.push_back(size * std::sin(0.02 * i * 2.4) + 0.4 * std::sin(0.02 * i * 9.0));
  return {"push", 0.02, samples};
}
GroundMotion vertical() {
  std::vector<double> samples;
  for (int i = 0; i <= 300; ++i) samples.push_back(1.2 * std::sin(i * 0.9));
  return {"up", 0.02, samples};
}

// A rigid block on two groups of two bearings at -b and +b.
struct Block {
  double weight = 16e6, half_width = 3.6, height = 7.0;  // N, m, m
  [[nodiscard]] double mass() const { return weight / gravity; }

  [[nodiscard]] Model model(AxialForces options = {}) const {
    Model model;
    options.base_height = height * m;
    const NodeId node = add(model, Node{.name = "block", .mass = mass() * kg});
    for (const double side : {-1.0, 1.0})
      add(model, Isolator<SofteningRubber>{.name = side < 0.0 ? "left" : "right",
                                           .upper = node,
                                           .law = bearing(),
                                           .count = 2,
                                           .weight = 0.5 * weight * N,
                                           .at = side * half_width * m,
                                           .weight_changes = true});
    add(model, Building{.name = "block", .base = node, .axial_forces = options});
    return model;
  }
};

// The same by Runge and Kutta's method: both groups have the same d, slip and largest |d|, and N_l, N_r = V/2 -+ x with
// 2 b x = h F + V d/2 (half of the displaced weight counts under rubber). F is found by iteration.
struct Reference {
  Block block;
  GroundMotion motion;
  double d = 0.0, v = 0.0, slip = 0.0, farthest = 0.0, force = 0.0, time = 0.0;
  double largest = 0.0, smallest_left = 1e9, weight_work = 0.0, heat = 0.0, first_unstable = -1.0;
  double k_left = 0.0, k_right = 0.0, swing = 0.0;
  int steps = 0;

  [[nodiscard]] static double critical(double at) {
    const double delta = 2.0 * std::acos(std::min(1.0, at / 0.7));
    return critical_at_rest * std::max(0.2, (delta - std::sin(delta)) / std::numbers::pi);
  }
  [[nodiscard]] static double stiffness(double n, double at) {
    const double ratio = n / critical(at);
    return k_20 * (n > 0.0 ? std::max(0.01, 1.0 - ratio * ratio) : 1.0);
  }
  // Round-off must not lead beyond the last sample.
  [[nodiscard]] GroundVector ground(double t) const { return motion.components_at(std::min(t, 6.0)); }
  [[nodiscard]] double load(double t) const { return block.weight * (1.0 + ground(t).z / gravity); }
  double acceleration(double t, double at, double) {
    const double strength = yield_force - k_20 * yield_displacement;
    const double q = std::clamp(strength / yield_displacement * (at - slip), -strength, strength);
    const double reached = std::max(farthest, std::abs(at));
    for (int i = 0; i < 200; ++i) {
      swing = (block.height * force + 0.5 * load(t) * at) / (2.0 * block.half_width);
      k_left = 2.0 * stiffness(0.5 * (0.5 * load(t) - swing), reached);
      k_right = 2.0 * stiffness(0.5 * (0.5 * load(t) + swing), reached);
      const double next = 4.0 * q + (k_left + k_right) * at, change = std::abs(next - force);
      force = next;
      if (change < 1e-9 * block.weight) break;
    }
    return -force / block.mass() - ground(t).x;
  }
  void run_to(double end) {
    constexpr double h = 2e-5;
    const double strength = yield_force - k_20 * yield_displacement, elastic = strength / yield_displacement;
    for (; time < end - 0.5 * h; ++steps) {
      const double a1 = acceleration(time, d, v), before = k_left + k_right, start = d, slip_before = slip,
                   q_before = std::clamp(elastic * (d - slip), -strength, strength);
      const double v2 = v + 0.5 * h * a1, a2 = acceleration(time + 0.5 * h, d + 0.5 * h * v, v2);
      const double v3 = v + 0.5 * h * a2, a3 = acceleration(time + 0.5 * h, d + 0.5 * h * v2, v3);
      const double v4 = v + h * a3, a4 = acceleration(time + h, d + h * v3, v4);
      d += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
      v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      time = std::min((steps + 1) * h, end);
      acceleration(time, d, v);
      const double q = std::clamp(elastic * (d - slip), -strength, strength);
      slip = d - q / elastic;
      farthest = std::max(farthest, std::abs(d));
      heat += 4.0 * 0.5 * (q_before + q) * (slip - slip_before);
      weight_work += 0.5 * start * d * (k_left + k_right - before);
      largest = std::max(largest, std::abs(d));
      smallest_left = std::min(smallest_left, 0.5 * load(time) - swing);
      if (first_unstable < 0.0 && 0.5 * (0.5 * load(time) + std::abs(swing)) > critical(farthest))
        first_unstable = time;
    }
  }
};

TEST(SofteningRubber, UnderOverturningFollowsAnIndependentProgram) {
  for (const bool moves_up : {false, true}) {
    const GroundMotion motion = moves_up ? with_vertical(horizontal(), vertical()) : horizontal();
    const Block block;
    Reference reference{block, motion};
    const Model model = block.model();
    Transient analysis{model, motion, {.tolerance = 1e-8}};
    for (int i = 1; i <= 3; ++i) {
      reference.run_to(2.0 * i);
      while (analysis.state().time() < 2.0 * i - 1e-9) analysis.advance();
      ASSERT_NEAR(analysis.state().time(), 2.0 * i, 1e-9);
      const NodeId node = model.node(0);
      EXPECT_NEAR(analysis.state().displacement(node), reference.d, 1e-5 * reference.largest) << i << moves_up;
      EXPECT_NEAR(analysis.state().velocity(node), reference.v, 2e-5 * reference.largest * 2.4);
      const auto bearings = analysis.state().weights()[0].bearings();
      EXPECT_NEAR(bearings[0].compression, 0.5 * reference.load(2.0 * i) - reference.swing, 1e-5 * block.weight);
      EXPECT_EQ(bearings[0].on_slab.slides, false);
    }
    const CaseResult result =
        run_case(model, motion, {.transient = {.tolerance = 1e-8}, .error_bars = ErrorBarMode::never});
    EXPECT_GT(reference.largest, 0.25);
    EXPECT_NEAR(peak(result, "displacement"), reference.largest, 1e-5 * reference.largest);
    EXPECT_NEAR(peak_in(result, "smallest_bearing_compression", "left").value, reference.smallest_left,
                1e-4 * block.weight);
    EXPECT_NEAR(result.energy.weight_work, reference.weight_work, 1e-4 * std::abs(reference.weight_work));
    EXPECT_NEAR(result.energy.hysteretic, reference.heat, 1e-4 * reference.heat);
    EXPECT_LT(result.energy.error_share(), 1e-6);
    EXPECT_NEAR(peak(result, "critical_load"), critical_at_rest, 1.0) << "at rest";
  }
}

TEST(SofteningRubber, EnergyClosesByTheMeanForceAndByQuadrature) {
  const GroundMotion motion = with_vertical(horizontal(), vertical());
  const Model model = Block{}.model({.may_pull = 100 * kN});
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{Newmark::average_acceleration()}})
    for (const double tolerance : {3e-5, 1e-8}) {
      const CaseResult result = run_case(
          model, motion,
          {.transient = {.integrator = integrator, .tolerance = tolerance}, .error_bars = ErrorBarMode::never});
      EXPECT_LT(result.energy.error_share(), tolerance > 1e-6 ? 1e-3 : 1e-6);
    }
}

// D begins at the displacement of the start.
TEST(SofteningRubber, BeginsAtItsDisplacement) {
  Model model;
  const NodeId node = add(model, Node{.name = "block", .mass = 1.6e6 * kg, .initial_displacement = 0.35 * m});
  add(model, Isolator<SofteningRubber>{.upper = node, .law = bearing(), .count = 4, .weight = 16 * MN});
  const CaseResult result =
      run_case(model, horizontal(0.0), {.transient = {.tolerance = 1e-8}, .error_bars = ErrorBarMode::never});
  const double force = 4.0 * (0.8219200 * k_20 * 0.35 + yield_force - k_20 * yield_displacement);
  EXPECT_NEAR(peak(result, "isolator_force"), force, 1e-6 * force);
  EXPECT_NEAR(result.energy.weight_work, 0.0, 1e-6 * force);
  EXPECT_LT(result.energy.error_share(), 1e-6);
}

TEST(SofteningRubber, ThatExceedsItsCriticalLoadIsAnEventAndAWarning) {
  const GroundMotion motion = horizontal(2.1);
  const Block heavy{.weight = 30e6, .height = 5.0};
  Reference reference{heavy, motion};
  reference.run_to(6.0);
  ASSERT_GT(reference.first_unstable, 0.0);
  const CaseResult result =
      run_case(heavy.model(), motion, {.transient = {.tolerance = 1e-7}, .error_bars = ErrorBarMode::never});
  const double left = result.peaks.empty() ? 0.0 : peak_in(result, "bearing_unstable", "left").time,
               right = peak_in(result, "bearing_unstable", "right").time;
  EXPECT_NEAR(std::min(left, right), reference.first_unstable, 1e-3);
  EXPECT_GE(peak_in(result, "bearing_unstable", "right").value, 1.0);
  EXPECT_TRUE(std::ranges::any_of(result.warnings, [](const std::string& warning) {
    return warning.find("is unstable for the first time at t = ") != std::string::npos;
  }));
  const CaseResult light =
      run_case(Block{.weight = 4e6, .height = 1.0}.model(), horizontal(0.2), {.error_bars = ErrorBarMode::never});
  EXPECT_TRUE(std::ranges::none_of(light.peaks, [](const Peak& each) { return each.quantity == "bearing_unstable"; }));
}

// Without horizontal motion N = W/4 (1 + a/g) in every bearing, and a grows by 2 m/s^2 per second.
TEST(SofteningRubber, IsUnstableFromTheInstantAtWhichItsLoadPassesTheCriticalOne) {
  const Block block{.weight = 80e6};
  const Model model = block.model();
  Transient analysis{
      model, with_vertical({"rest", 0.5, {0.0, 0.0, 0.0, 0.0}}, {"up", 0.5, {0.0, 1.0, 2.0, 3.0}}), {.step = 100 * ms}};
  analysis.run();
  const double expected = 0.5 * gravity * (critical_at_rest / (0.25 * block.weight) - 1.0);
  for (const WeightOnBearings::Bearing& bearing : analysis.state().weights()[0].bearings())
    EXPECT_NEAR(bearing.first_unstable, expected, 1e-7);  // s, by the digits of critical_at_rest
}

// Without axial forces each bearing has its share of the weight; D grows all the same.
TEST(SofteningRubber, OfABuildingWithoutAxialForcesCarriesAConstantWeight) {
  const ShearBuilding design{.storeys = 1,
                             .floor_mass = 800 * tonne,
                             .storey_stiffness = 100 * GN / m,
                             .base_mass = 831 * tonne,
                             .isolation = Isolator<SofteningRubber>{.law = bearing(), .count = 4}};
  Model model;
  add(model, design);
  const CaseResult result =
      run_case(model, horizontal(), {.transient = {.tolerance = 1e-8}, .error_bars = ErrorBarMode::never});
  EXPECT_LT(result.energy.weight_work, 0.0);
  EXPECT_TRUE(result.energy.weights_change);
  EXPECT_LT(result.energy.error_share(), 1e-6);
  // The weight does not overturn: N = W/4 in the reference of a block without height.
  const Block flat{.weight = 1631e3 * gravity, .half_width = 1e9, .height = 0.0};
  Reference reference{flat, horizontal()};
  reference.run_to(6.0);
  EXPECT_NEAR(peak(result, "isolator_deformation"), reference.largest, 1e-4 * reference.largest);
  // As refused without a weight at all.
  Model alone;
  const NodeId node = add(alone, Node{.name = "base", .mass = 1 * tonne});
  EXPECT_NE(message_of([&] {
              add(alone, Isolator<SofteningRubber>{.upper = node, .law = bearing()});
            }).find("weight that it carries"),
            std::string::npos);
}

// A slab on four bearings, turned with its motion.
TEST(SofteningRubber, InPlanDoesNotDependOnTheAxes) {
  const GroundMotion x = horizontal();
  const GroundMotion y{"across", 0.02, [] {
                         std::vector<double> samples;
                         for (int i = 0; i <= 300; ++i) samples.push_back(1.4 * std::sin(0.02 * i * 3.1 + 0.5));
                         return samples;
                       }()};
  const auto run = [&](double angle, const AxialForces& options) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](double px, double py) {
      return PlanPosition{(c * px - s * py) * m, (s * px + c * py) * m};
    };
    Model model;
    const DiaphragmId base = add(model, Diaphragm{.name = "base",
                                                  .mass = 1.6e6 * kg,
                                                  .rotary_inertia = 3e7 * kg * m * m,
                                                  .centre_of_mass = turned(0.4, -0.2),
                                                  .outline = rectangle(20 * m, 20 * m)});
    std::vector<PlanBearings::Placed> bearings;
    for (const auto& [px, py] : {std::pair{-4.0, -3.0}, {4.0, -3.0}, {-4.0, 3.0}, {4.0, 3.0}})
      bearings.emplace_back(turned(px, py), bearing());
    PlanBearings{bearings}.add_under(model, Check{"slab", ""}, "", base, rectangle(20 * m, 20 * m), 1.6e6 * gravity * N,
                                     options, {c * 0.4 + s * 0.2, s * 0.4 - c * 0.2});
    add(model, Building{.base = base, .axial_forces = options});
    PlanMotion motion{x, y, angle * rad};
    motion.vertical = vertical();
    Transient analysis{model, motion, {.tolerance = 1e-6}};
    analysis.run();
    const Vector& u = analysis.state().motion().displacement;
    return std::vector{c * u[0] + s * u[1], -s * u[0] + c * u[1], u[2],
                       analysis.state().weights()[0].bearings()[1].compression};
  };
  const AxialForces options{.base_height = 6 * m};
  const std::vector<double> plain = run(0.0, options), turned = run(37.0 / 180.0 * std::numbers::pi, options);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(turned[i], plain[i], 1e-9) << i;
  EXPECT_NEAR(turned[3], plain[3], 1e-9 * plain[3] + 1e-1);
}

// Four bearings in plan that move along a line are the two groups.
TEST(SofteningRubber, InPlanAlongALineIsThatOfTheLine) {
  const GroundMotion motion = with_vertical(horizontal(), vertical());
  const Block block;
  Reference reference{block, motion};
  reference.run_to(6.0);
  Model model;
  const DiaphragmId base = add(model, Diaphragm{.name = "base",
                                                .mass = block.mass() * kg,
                                                .rotary_inertia = 3e7 * kg * m * m,
                                                .outline = rectangle(20 * m, 20 * m)});
  const AxialForces options{.base_height = block.height * m};
  PlanBearings{grid(2, 2, bearing())}.add_under(model, Check{"slab", ""}, "", base,
                                                rectangle(2 * block.half_width * m, 4 * m), block.weight * N, options);
  add(model, Building{.base = base, .axial_forces = options});
  PlanMotion shaking{horizontal(), horizontal().scaled_by(0.0)};
  shaking.vertical = vertical();
  const CaseResult result =
      run_case(model, shaking, {.transient = {.tolerance = 1e-8}, .error_bars = ErrorBarMode::never});
  EXPECT_NEAR(peak(result, "displacement_x"), reference.largest, 2e-5 * reference.largest);
  EXPECT_NEAR(result.energy.weight_work, reference.weight_work, 1e-3 * std::abs(reference.weight_work));
  EXPECT_LT(result.energy.error_share(), 1e-6);
  EXPECT_NEAR(peak(result, "critical_load"), critical_at_rest, 1.0);
}

}  // namespace
}  // namespace moat::testing
