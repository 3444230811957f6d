// Weights at rest, load and notes of buildings with axial forces, by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "elements/line/softening_rubber.hpp"
#include "materials/plan/biaxial_linear.hpp"
#include "moat.hpp"
#include "peak_in.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double gravity = 9.80665;  // m/s^2

GroundMotion constant(double value) { return {"push", 0.5, {value, value}}; }

bool any_contains(const std::vector<std::string>& list, const std::string& part) {
  return std::ranges::any_of(list, [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

// Six, two and four bearings at -4, 0 and 4 m: N = W/12 + M (x - x_k)/sum (x - x_k)^2 on each, x_k = -2/3 m.
TEST(WeightShares, GroupsAreAsStiffAsTheNumberOfTheirBearings) {
  const FlatSlider slider{.friction = 0.3};
  const auto group = [&](const char* name, int count, Length at) {
    return Isolator<FlatSlider>{.name = name, .law = slider, .count = count, .at = at};
  };
  Model model;
  add(model, ShearBuilding{
                 .storeys = 1,
                 .floor_mass = 800 * tonne,
                 .storey_stiffness = 1 * GN / m,
                 .base_mass = 400 * tonne,
                 .isolation = Isolation{group("left", 6, -4 * m), group("middle", 2, 0 * m), group("right", 4, 4 * m)},
                 .storey_height = 6 * m,
                 .axial_forces = AxialForces{.shares = AxialForces::Shares::equal, .displaced_weight = false}});
  Transient analysis{model, constant(0.5), {.step = 1 * ms}};
  const double counts[]{6.0, 2.0, 4.0}, places[]{-4.0, 0.0, 4.0}, centre = -2.0 / 3.0;
  double inertia = 0.0;
  for (int i = 0; i < 3; ++i) inertia += counts[i] * (places[i] - centre) * (places[i] - centre);
  for (int step = 0; step < 20; ++step) {
    analysis.advance();
    const WeightOnBearings& weight = analysis.state().weights()[0];
    const double moment = weight.overturning_moment().x;
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_NEAR(weight.bearings()[i].compression,
                  counts[i] * (1.2e6 * gravity / 12.0 + moment * (places[i] - centre) / inertia), 1e-3)
          << i;
  }
}

// The slider on the left rises; the rubber on the right, which could pull, is pressed. The moment that they cannot
// balance is dropped, and they carry the load.
TEST(WeightShares, BearingsThatRockAndMayPullCarryTheLoad) {
  constexpr double mass = 1e6;  // kg
  Model model;
  const NodeId node = add(model, Node{.name = "block", .mass = mass * kg});
  add(model, Isolator<FlatSlider>{.name = "left",
                                  .upper = node,
                                  .law = {.friction = 0.3},
                                  .weight = 0.5 * mass * gravity * N,
                                  .at = -1 * m,
                                  .weight_changes = true});
  add(model, Isolator<Bilinear>{
                 .name = "right",
                 .upper = node,
                 .law = {.yield_force = 20 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m},
                 .weight = 0.5 * mass * gravity * N,
                 .at = 1 * m,
                 .weight_changes = true});
  add(model, Building{.name = "block",
                      .base = node,
                      .axial_forces = AxialForces{.base_height = 8 * m,
                                                  .displaced_weight = false,
                                                  .may_pull = 100 * kN,
                                                  .rocking = AxialForces::Rocking::continues}});
  Transient analysis{model, with_vertical(constant(-4.0), constant(-0.4 * gravity)), {.step = 1 * ms}};
  for (int i = 0; i < 100; ++i) {
    analysis.advance();
    const WeightOnBearings& weight = analysis.state().weights()[0];
    ASSERT_NEAR(weight.load(), 0.6 * mass * gravity, 1e-3);
    ASSERT_NEAR(weight.bearings()[0].compression + weight.bearings()[1].compression, weight.load(), 1e-3) << i;
  }
  EXPECT_GT(analysis.state().weights()[0].rocking_time(), 0.0);
}

// 1 % of the largest distance of two bearings, 8 m, in any order.
TEST(WeightShares, EccentricLoadIsNotedInAnyOrderOfTheBearings) {
  for (const double more : {0.009, 0.015}) {  // of the weight; the load is 8 m times that beside the middle
    const double weight = 800e3 * gravity;
    const auto group = [&](const char* name, double share, Length at) {
      return Isolator<FlatSlider>{.name = name, .law = {.friction = 0.1}, .weight = share * weight * N, .at = at};
    };
    const auto left = group("left", 0.335 + more, -4 * m), middle = group("middle", 0.33, 0 * m),
               right = group("right", 0.335 - more, 4 * m);
    for (const Isolation& isolation : {Isolation{left, middle, right}, Isolation{middle, left, right}}) {
      Model model;
      add(model, ShearBuilding{.storeys = 1,
                               .floor_mass = 400 * tonne,
                               .storey_stiffness = 1 * GN / m,
                               .base_mass = 400 * tonne,
                               .isolation = isolation,
                               .storey_height = 4 * m,
                               .axial_forces = AxialForces{}});
      const Transient analysis{model, constant(0.1), {}};
      EXPECT_EQ(any_contains(analysis.assumptions(), "m from the centre of mass"), more > 0.01) << more;
    }
  }
}

// A tower stands 4 m beside the middle of a base of the same mass, so that the load is 2 m beside it.
TEST(WeightShares, LoadOfATowerOnASharedBaseIsNotEccentric) {
  for (const double distance : {2.0, 0.0}) {
    Model model;
    const auto slab = [&](const char* name, double x) {
      return add(model, Diaphragm{.name = name,
                                  .mass = 1000 * tonne,
                                  .rotary_inertia = 2e7 * kg * m * m,
                                  .centre_of_mass = {x * m, 0 * m},
                                  .outline = rectangle(20 * m, 20 * m)});
    };
    const DiaphragmId base = slab("base", 0.0), tower = slab("tower", 4.0);
    for (const double y : {-3.0, 3.0})
      add(model, PlanarSpring<BiaxialLinear>{.name = y < 0.0 ? "south" : "north",
                                             .lower = PlanPoint{base, {4 * m, y * m}},
                                             .upper = PlanPoint{tower, {4 * m, y * m}},
                                             .law = {.stiffness = 1 * GN / m}});
    const double weight = 2e6 * gravity;
    std::vector<PlanBearings::Placed> bearings;
    for (const double x : {-5.0, 5.0})
      for (const double y : {-5.0, 5.0}) {
        bearings.emplace_back(PlanPosition{x * m, y * m}, FlatSlider{.friction = 0.1});
        bearings.back().weight = 0.25 * weight * (1.0 + distance / x) * N;
      }
    PlanBearings{bearings}.add_under(model, Check{"slab", ""}, "", base, rectangle(20 * m, 20 * m), weight * N,
                                     AxialForces{});
    add(model, Building{.name = "base", .base = base, .axial_forces = AxialForces{}});
    add(model, Building{.name = "tower", .base = base, .floors = {tower}, .shares_base = true});
    const Transient analysis{model, PlanMotion{constant(0.1), constant(0.0)}, {}};
    EXPECT_EQ(any_contains(analysis.assumptions(), "m from the centre of mass"), distance == 0.0) << distance;
  }
}

PlanBuilding house(const char* name, Length x, std::optional<AxialForces> axial_forces) {
  return {.name = name,
          .outline = rectangle(8 * m, 6 * m, {x, 0 * m}),
          .storeys = 1,
          .floor_mass = 300 * tonne,
          .columns = grid(2, 2, StoreyColumn{.stiffness = 200 * MN / m}),
          .base_mass = 100 * tonne,
          .bearings = grid(2, 2, FlatSlider{.friction = 0.1, .restoring_stiffness = 1 * MN / m}),
          .storey_height = 3 * m,
          .axial_forces = axial_forces};
}

TEST(WeightShares, BuildingsWithAConstantWeightAreNamedBesideOthers) {
  Model model;
  add(model, house("loaded", 0 * m, AxialForces{}));
  add(model, house("plain", 30 * m, {}));
  const CaseResult result =
      run_case(model, PlanMotion{constant(0.1), constant(0.0)}, {.error_bars = ErrorBarMode::never});
  EXPECT_TRUE(any_contains(result.assumptions, "\"plain\": Vertical motion, rocking"));
  EXPECT_FALSE(any_contains(result.assumptions, "\"loaded\": Vertical motion"));
}

// P_cr at 0.35 m is 9.4787791 MN: on each of four bearings it is exceeded by 10 MN, not by 4 MN.
TEST(WeightShares, RubberUnderAConstantWeightReportsItsCriticalLoad) {
  for (const double weight : {4e6, 10e6}) {
    Model model;
    const NodeId node =
        add(model, Node{.name = "block", .mass = 4.0 * weight / gravity * kg, .initial_displacement = 0.35 * m});
    add(model, Isolator<SofteningRubber>{.upper = node,
                                         .law = {.bearing = Bilinear{.yield_force = 264 * kN,
                                                                     .yield_displacement = 1 * cm,
                                                                     .post_yield_stiffness = 2.4 * MN / m},
                                                 .rubber = {.diameter = 0.7 * m,
                                                            .layer_thickness = 6 * mm,
                                                            .rubber_thickness = 180 * mm,
                                                            .shear_modulus = 0.5 * MPa}},
                                         .count = 4,
                                         .weight = 4.0 * weight * N});
    const CaseResult result = run_case(model, constant(0.0), {.error_bars = ErrorBarMode::never});
    EXPECT_NEAR(peak(result, "critical_load"), 9.4787791e6, 10.0);
    EXPECT_EQ(any_contains(result.warnings, "became unstable"), weight > 9e6);
  }
}

}  // namespace
}  // namespace moat::testing
