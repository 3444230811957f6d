// The reference history of a tower in plan: peaks of an independent program (Runge-Kutta of fourth order at 1 us).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "moat.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using testing::peak;

// Base of 800 t and floor of 700 t, both 20 x 12 m; the floor's centre of mass at (1.0, 0.6) m. Without walls for a
// negative friction.
CaseResult reference_case(double friction, CaseOptions options = {}) {
  Model model;
  const PlanOutline outline = rectangle(20 * m, 12 * m);
  const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = 800 * tonne, .outline = outline}),
                    floor = add(model, Diaphragm{.name = "floor",
                                                 .mass = 700 * tonne,
                                                 .centre_of_mass = {1.0 * m, 0.6 * m},
                                                 .outline = outline});
  add(model, Building{.base = base, .floors = {floor}});
  const PlanOutline walls = rectangle(20.5 * m, 12.5 * m);
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanPosition at = outline.corners[i];
    const std::string index = std::to_string(i + 1);
    for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
      add(model, PlanSpring<Linear>{.name = "column " + index + (direction.x > 0.0 ? " x" : " y"),
                                    .lower = PlanPoint{base, at},
                                    .upper = PlanPoint{floor, at},
                                    .direction = direction,
                                    .law = {.stiffness = 100 * MN / m, .damping = 1 * MN * s / m}});
    add(model, PlanBearing<BiaxialBoucWen>{.name = "bearing " + index,
                                           .under = base,
                                           .at = at,
                                           .law = {.characteristic_strength = 184 * kN,
                                                   .yield_displacement = 10 * mm,
                                                   .post_yield_stiffness = 1.6 * MN / m}});
    for (std::size_t wall = 0; friction >= 0.0 && wall < 4; ++wall) {
      const PlanVector begin = walls.corner(wall), end = walls.corner(wall + 1);
      if (dot(begin - at.si(), -turned_left(end - begin) / length(end - begin)) > 1.0) continue;
      add(model, CornerGap<HertzDamp>{.name = "corner " + index + " wall " + std::to_string(wall + 1),
                                      .place = "moat",
                                      .corner = PlanPoint{base, at},
                                      .edge_of = ground,
                                      .edge_begin = walls.corners[wall],
                                      .edge_end = walls.corners[(wall + 1) % 4],
                                      .law = {.stiffness = 1.0e9 * N / m_3_2, .restitution = 0.65},
                                      .friction = {friction, 5e8 * N / m}});
    }
  }
  if (options.transient.end.si() == 0.0) options.transient.end = 12 * s;
  const auto pulse = [](double phase) { return near_fault_pulse({.phase = phase}); };
  return run_case(
      model, PlanMotion{pulse(0.25 * pi).scaled_to_pga(0.40 * g), pulse(-0.25 * pi).scaled_to_pga(0.25 * g)}, options);
}

struct Expected {
  const char *quantity, *where;
  double value;
};

void compare(const CaseResult& result, const std::vector<Expected>& expected, double tolerance) {
  for (const Expected& each : expected) {
    const double value = peak(result, each.quantity, each.where);
    EXPECT_NEAR(value / each.value, 1.0, tolerance) << each.quantity << " at " << each.where << ": " << value;
  }
}

void expect_energy_closes(const CaseResult& result) {
  const EnergyBalance& energy = result.energy;
  const double scale = std::max(energy.largest_input, energy.largest_kinetic);
  EXPECT_LT(std::abs(energy.integration_error), 1e-3 * scale);
  EXPECT_LT(std::abs(energy.equation_residual), 1e-3 * scale);
}

double friction_loss(const CaseResult& result) {
  double sum = 0.0;
  for (const Impact& impact : result.impacts) sum += impact.friction_loss;
  return sum;
}

void expect_first_touch(const CaseResult& result) {
  const Impact& first = result.impacts.at(0);
  EXPECT_EQ(first.where, "corner 4 wall 4");
  EXPECT_NEAR(first.start, 2.657342, 5e-5);
  EXPECT_NEAR(first.approach_speed / 0.587186, 1.0, 1e-3);
}

constexpr double within = 1e-3;

TEST(PlanReference, NoWalls) {
  const CaseResult result = reference_case(-1.0);
  compare(result,
          {{"displacement_x", "base", 0.2846432},
           {"displacement_y", "base", 0.1887396},
           {"rotation", "base", 0.00166659},
           {"rotation", "floor", 0.00168014},
           {"corner_displacement", "base", 0.2968031},
           {"absolute_acceleration_x", "base", 1.412520},
           {"absolute_acceleration_y", "base", 0.908695},
           {"absolute_acceleration_x", "floor", 1.477800},
           {"absolute_acceleration_y", "floor", 0.895862},
           {"corner_drift", "floor", 0.00274475}},
          within);
  expect_energy_closes(result);
}

TEST(PlanReference, WallsWithFriction) {
  const CaseResult result = reference_case(0.2);
  compare(result,
          {{"displacement_x", "base", 0.2823535},
           {"displacement_y", "base", 0.1655518},
           {"rotation", "base", 0.00412921},
           {"rotation", "floor", 0.0041699},
           {"corner_displacement", "base", 0.3334363},
           {"absolute_acceleration_x", "base", 10.52852},
           {"absolute_acceleration_y", "base", 1.680583},
           {"absolute_acceleration_x", "floor", 13.66834},
           {"absolute_acceleration_y", "floor", 1.876596},
           {"corner_drift", "floor", 0.02410503},
           {"impact_force", "moat", 10.55833e6},
           {"friction_force", "moat", 2.111666e6}},
          within);
  EXPECT_EQ(result.impacts.size(), 6U);
  expect_first_touch(result);
  EXPECT_NEAR(result.energy.friction / 229012.0, 1.0, within);
  EXPECT_NEAR(friction_loss(result), result.energy.friction, 1e-6 * result.energy.friction);
  expect_energy_closes(result);
}

TEST(PlanReference, EquationsBalanceToRoundOffInStepsOfAverageAcceleration) {
  const CaseResult result =
      reference_case(0.2, {.transient = {.step = 1 * ms, .end = 4 * s, .force_tolerance = 1e-12}});
  EXPECT_GT(result.energy.friction, 0.0);
  EXPECT_LT(std::abs(result.energy.equation_residual),
            1e-9 * std::max(result.energy.largest_input, result.energy.largest_kinetic));
}

TEST(PlanReference, WallsWithMuchFriction) {
  // The peaks after the second impact depend on it strongly.
  const CaseResult result = reference_case(0.6);
  constexpr double after_impacts = 5e-3;
  compare(result,
          {{"displacement_x", "base", 0.2787646},
           {"displacement_y", "base", 0.225302},
           {"rotation", "base", 0.00873233},
           {"rotation", "floor", 0.00880506},
           {"corner_displacement", "base", 0.368192},
           {"absolute_acceleration_x", "base", 13.75798},
           {"absolute_acceleration_y", "base", 7.226641},
           {"absolute_acceleration_x", "floor", 16.97009},
           {"absolute_acceleration_y", "floor", 8.953589},
           {"corner_drift", "floor", 0.03315831},
           {"impact_force", "moat", 15.49647e6},
           {"friction_force", "moat", 9.297883e6}},
          after_impacts);
  EXPECT_EQ(result.impacts.size(), 5U);
  expect_first_touch(result);
  EXPECT_NEAR(result.energy.friction / 242411.0, 1.0, after_impacts);
  expect_energy_closes(result);
}

}  // namespace
}  // namespace moat
