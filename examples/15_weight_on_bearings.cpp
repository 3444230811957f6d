// Tour 15: the weight on the bearings of a tall tower. Read 08_friction_pendulum.cpp and 05_plan.cpp before.
//
// Twelve storeys on nine friction pendulums, 16 m wide and 45 m high. Overturning moves the weight to the bearings of
// one side, and the vertical motion near a fault adds as much: friction follows both at once, and a bearing may lift.
// With .axial_forces all of this is in the results: `bearing_compression`, `smallest_bearing_compression`, `uplifts`,
// `overturning_moment_x`. With --weight constant the weight on every bearing stays that at rest, as if the tower were
// low.
//
//     ./moat run examples/15_weight_on_bearings.cpp
//     ./moat run examples/15_weight_on_bearings.cpp --weight constant --out results/constant_weight
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "The weight on the bearings of a tower"};
  const bool constant = script.text("weight", "changes", "on every bearing", {"changes", "constant"}) == "constant";
  const Length gap = script.length("gap", 60 * cm, "clearance on each side");

  PlanBuilding tower{
      .outline = rectangle(16 * m, 16 * m),
      .storeys = 12,
      .floor_mass = 260 * tonne,
      .mass_offset = PlanPosition{0.8 * m, 0 * m},
      .columns = grid(3, 3, StoreyColumn{.stiffness = 90 * MN / m}),
      .damping = {.ratio = 0.03},
      .base_mass = 320 * tonne,
      .bearings = grid(3, 3,
                       FrictionPendulum{.radius = 2.2 * m,
                                        .friction = VelocityPressureDependent{.slow = 0.03,
                                                                              .at_zero_pressure = 0.10,
                                                                              .reduction = 0.05,
                                                                              .pressure_factor = 2.5e-8 * m * m / N,
                                                                              .area = 0.12 * m * m,  // of each bearing
                                                                              .rate = 50 * s / m}}),
      .storey_height = 3.7 * m};
  if (!constant) tower.axial_forces = AxialForces{.base_height = 0.8 * m};

  Model model;
  const PlanBuildingParts parts = add(model, tower);
  add(model, PlanMoat{.around = parts.base, .clearance = gap, .law = LinearElastic{.stiffness = 200 * MN / m}});

  PlanMotion motion{near_fault_pulse({.pulse_period = 2.5 * s}).scaled_to_pga(0.17 * g),
                    near_fault_pulse({.pulse_period = 1.6 * s}).scaled_to_pga(0.10 * g)};
  if (!constant) motion.vertical = near_fault_pulse({.pulse_period = 0.3 * s}).scaled_to_pga(0.4 * g);
  return script.run(model, motion);
}
