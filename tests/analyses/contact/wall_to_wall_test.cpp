// Clearance 0: bodies that are built wall to wall. A touch begins where the indentation first grows.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "peak_in.hpp"
#include "reference_history.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double mass = 500e3, spring = 20e6, contact = 1e9;  // kg, N/m, N/m
const LinearElastic elastic{.stiffness = contact * N / m};

NodeId add_body(Model& model, const std::string& name, double its_mass, double stiffness, double speed = 0.0) {
  return add(model, Oscillator{name, its_mass, std::sqrt(stiffness / its_mass), 0.0, 0.0, speed});
}

// Two oscillators under a pulse, and the same of the independent program with a clearance of 1e-12 m.
TEST(WallToWall, IsTheLimitOfSmallClearances) {
  const GroundMotion pulse = near_fault_pulse({.pulse_period = 1 * s}).scaled_to_pga(0.3 * g);
  PlainModel plain;
  plain.nodes = {{"a", mass}, {"b", 800e3}};
  plain.springs = {{.name = "a spring", .upper = 0, .stiffness = spring},
                   {.name = "b spring", .upper = 1, .stiffness = 4.0 * spring}};
  plain.gaps = {{.name = "gap",
                 .place = "gap",
                 .left = {0, 0},
                 .right = {1, 1},
                 .clearance = 1e-12,
                 .law = {.kind = PlainLawKind::linear_elastic, .stiffness = contact}}};
  plain.motion = {pulse.time_step(), {pulse.samples().begin(), pulse.samples().end()}};
  plain.end = pulse.duration();
  const ReferenceResult reference = reference_history(plain);

  Model model;
  const NodeId a = add_body(model, "a", mass, spring), b = add_body(model, "b", 800e3, 4.0 * spring);
  add(model, Gap{.name = "gap", .left = a, .right = b, .clearance = 0 * m, .law = elastic});
  const CaseResult result = run_case(model, pulse);
  EXPECT_EQ(result.impacts.size(), reference.touches.size());
  EXPECT_GT(result.impacts.size(), 20U);
  for (const ReferencePeak& expected : reference.peaks)
    EXPECT_NEAR(peak(result, expected.quantity, expected.where), expected.value, 2e-4 * expected.value)
        << expected.quantity << " of " << expected.where;
  EXPECT_EQ(result.clearances.at(0).clearance, 0.0);
}

// Both walls are the springs of one oscillator: u = v/w sin wt, and every half period is an impact.
TEST(WallToWall, BothWallsMakeOneOscillator) {
  const double w = std::sqrt((spring + contact) / mass), v = 0.3;
  Model model;
  const NodeId body = add_body(model, "body", mass, spring, v);
  add(model, Moat{.around = body, .clearance = 0 * m, .law = elastic});
  const CaseResult result = run_case(model, still_ground(4.5 * std::numbers::pi / w * s, 1 * ms));
  ASSERT_EQ(result.impacts.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(result.impacts[i].where, i % 2 == 0 ? "moat right" : "moat left");
    EXPECT_NEAR(result.impacts[i].approach_speed, v, 1e-4 * v);
    EXPECT_NEAR(result.impacts[i].start, static_cast<double>(i) * std::numbers::pi / w, 1e-5);
  }
  EXPECT_NEAR(peak(result, "displacement", "body"), v / w, 1e-4 * v / w);
  EXPECT_NEAR(peak(result, "impact_force", "moat"), contact * v / w, 1e-4 * contact * v / w);
}

// The ground leaves the body behind, which leans on its wall from rest: u = a/w^2 (1 - cos wt).
TEST(WallToWall, ATouchFromRestGrowsFromNothing) {
  const double w = std::sqrt((spring + contact) / mass), a = 2.0;
  Model model;
  const NodeId body = add_body(model, "body", mass, spring);
  add(model, Gap{.name = "wall", .left = body, .right = ground, .clearance = 0 * m, .law = elastic});
  add(model, Gap{.name = "behind", .left = ground, .right = body, .clearance = 0 * m, .law = elastic});
  const CaseResult result = run_case(model, constant_acceleration(-a, 1.5 * std::numbers::pi / w * s, 1 * ms));
  ASSERT_EQ(result.impacts.size(), 1U);
  EXPECT_EQ(result.impacts[0].where, "wall");
  EXPECT_LT(result.impacts[0].approach_speed, 1e-5);
  EXPECT_NEAR(peak(result, "impact_force", "wall"), 2.0 * a * contact / (w * w), 2e-4 * a * contact / (w * w));
  EXPECT_EQ(peak(result, "impact_force", "behind"), 0.0);
}

// Equal buildings move together: round-off is no impact, and their gap changes no number.
TEST(WallToWall, BuildingsThatMoveTogetherDoNotTouch) {
  const GroundMotion pulse = near_fault_pulse({.pulse_period = 1 * s}).scaled_to_pga(0.4 * g);
  const auto run = [&](bool with_gaps) {
    Model model;
    std::vector<Building> towers;
    for (const char* name : {"a", "b"})
      towers.push_back(add(model, ShearBuilding{.name = name,
                                                .storeys = 6,
                                                .floor_mass = 317 * tonne,
                                                .storey_stiffness = 0.73 * GN / m,
                                                .damping = {.ratio = 0.05},
                                                .base_mass = 411 * tonne,
                                                .isolation = LeadRubberBearing{.yield_force = 0.61 * MN,
                                                                               .yield_displacement = 1 * cm,
                                                                               .post_yield_stiffness = 7.3 * MN / m}}));
    for (int floor = 1; with_gaps && floor <= 6; ++floor)
      add(model, Gap{.name = "gap " + std::to_string(floor),
                     .left = towers[0].floor(floor),
                     .right = towers[1].floor(floor),
                     .clearance = 0 * m,
                     .law = ExactHertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6}});
    return run_case(model, pulse);
  };
  const CaseResult with = run(true), without = run(false);
  EXPECT_TRUE(with.impacts.empty());
  for (const GapClearance& gap : with.clearances) EXPECT_NEAR(gap.left, 0.0, 1e-12) << gap.where;
  EXPECT_NEAR(peak(with, "displacement", "a floor 6"), peak(without, "displacement", "a floor 6"), 1e-6);
}

// A slab on a spring along x and one along y at each of its corners.
DiaphragmId add_slab(Model& model, const std::string& name, PlanPosition centre, Speed speed) {
  const PlanOutline outline = rectangle(20 * m, 12 * m, centre);
  const DiaphragmId slab = add(
      model,
      Diaphragm{
          .name = name, .mass = mass * kg, .centre_of_mass = centre, .outline = outline, .initial_velocity_x = speed});
  for (const PlanPosition& at : outline.corners)
    for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
      add(model, PlanSpring<Linear>{.name = name + std::to_string(at.x.si()) + " " + std::to_string(at.y.si()) + " " +
                                            std::to_string(direction.x),
                                    .lower = PlanPoint{ground, at},
                                    .upper = PlanPoint{slab, at},
                                    .direction = direction,
                                    .law = {.stiffness = 0.25 * spring * N / m}});
  return slab;
}

TEST(WallToWall, InPlanBothWallsMakeOneOscillator) {
  const double w = std::sqrt((spring + 2.0 * contact) / mass), v = 0.3;
  for (const bool given : {false, true}) {
    Model model;
    const DiaphragmId slab = add_slab(model, "slab", {3 * m, 1 * m}, v * m / s);
    PlanMoat<LinearElastic> moat{.around = slab, .law = elastic, .friction = 0.3};
    if (given)
      moat.walls = rectangle(20 * m, 12 * m, {3 * m, 1 * m});
    else
      moat.clearance = 0 * m;
    add(model, moat);
    const CaseResult result = run_case(model, still_ground(4.5 * std::numbers::pi / w * s, 0.5 * ms));
    EXPECT_EQ(result.impacts.size(), 10U) << "two corners each, and none at the walls along the motion";
    EXPECT_NEAR(peak(result, "impact_force", "moat"), contact * v / w, 1e-3 * contact * v / w);
    EXPECT_NEAR(peak(result, "displacement_y", "slab"), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace moat
