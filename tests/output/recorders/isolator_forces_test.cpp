// The force of all isolators together, without impacts.
#include "output/recorders/isolator_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analyses/questions/study.hpp"
#include "message_of.hpp"
#include "moat.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

Model on_a_line(Length clearance) {
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 1,
                                                 .floor_mass = 400 * tonne,
                                                 .storey_stiffness = 700 * MN / m,
                                                 .base_mass = 450 * tonne,
                                                 .isolation = LeadRubberBearing{.yield_force = 500 * kN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 5 * MN / m}});
  add(model, Moat{.around = building.base,
                  .clearance = clearance,
                  .law = ExactHertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6}});
  return model;
}

const GroundMotion pulse = near_fault_pulse({.quiet_after = 1 * s});

// All isolation is one element: F = k_2 d + (F_y - k_2 d_y) at the largest displacement.
TEST(IsolatorForces, OnALineAreThoseOfTheIsolation) {
  for (const Length clearance : {5 * m, 10 * cm}) {
    const StudyRecord record = peaks_of(on_a_line(clearance), pulse, {.step = 2 * ms});
    const double isolators = value_of(record, "total_isolator_force", "base"),
                 shear = value_of(record, "total_base_shear", "base");
    const double displacement = value_of(record, "displacement", "base");
    EXPECT_NEAR(isolators / (5e6 * displacement + 450e3), 1.0, 1e-3) << clearance.si();
    if (clearance > 1 * m)
      EXPECT_NEAR(isolators / shear, 1.0, 1e-3);
    else
      EXPECT_GT(shear, 3.0 * isolators) << "with the impacts";
  }
}

// Without impacts and dampers the inertia above is that of the bearings, in each direction.
TEST(IsolatorForces, InPlanAreTheSumOfTheBearings) {
  Model model;
  const auto tower =
      add(model, testing::small_plan_building(
                     1, {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m}));
  add(model, PlanMoat{.around = tower.base,
                      .clearance = 5 * m,
                      .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                      .reach = 6 * m});
  const GroundMotion pair = PlanMotion{pulse, pulse.scaled_by(0.5)}.resolved();
  const StudyRecord record = peaks_of(model, pair, {.step = 2 * ms});
  for (const std::string direction : {"_x", "_y"})
    EXPECT_NEAR(value_of(record, "total_isolator_force" + direction, "base") /
                    value_of(record, "total_base_shear" + direction, "base"),
                1.0, 1e-3);
  EXPECT_GT(value_of(record, "total_isolator_force_x", "base"),
            1.5 * value_of(record, "total_isolator_force_y", "base"));
}

// A damper at the base is no isolator: the base shear has its force, and a gap that never closes changes nothing.
TEST(IsolatorForces, AreTheSameWithAndWithoutAGap) {
  const auto forces = [](bool has_gap) {
    Model model;
    const Building building = add(
        model,
        ShearBuilding{.storeys = 1,
                      .floor_mass = 500 * tonne,
                      .storey_stiffness = 1 * GN / m,
                      .base_mass = 500 * tonne,
                      .isolation = LeadRubberBearing{
                          .yield_force = 500 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 6 * MN / m}});
    add(model, ViscousDamper{.name = "damper", .lower = ground, .upper = building.base, .damping = 2 * MN * s / m});
    if (has_gap)
      add(model, Moat{.around = building.base, .clearance = 5 * m, .law = LinearElastic{.stiffness = 1 * GN / m}});
    const StudyRecord record = peaks_of(model, pulse, {.step = 5 * ms});
    return std::pair{value_of(record, "total_isolator_force", "base"), value_of(record, "total_base_shear", "base")};
  };
  const auto [isolators, shear] = forces(false);
  EXPECT_NEAR(isolators, forces(true).first, 1e-12 * isolators);
  EXPECT_GT(shear, 1.2 * isolators);
}

}  // namespace
}  // namespace moat
