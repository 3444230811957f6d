// Tour 5: an isolated tower in plan, whose corners hit the walls of its moat. Read 01_moat_wall.cpp before.
//
//        +-----------------------------+ walls        Two components of a near-fault pulse. The masses of the
//        |  o----------o----------o    |              floors are off the centre, so that the building turns and
//        |  |          x mass     |    |              its corners move further than its centre. Where a corner
//        |  o----------o----------o    |              hits a wall, the Hertz-damp law pushes it back and friction
//        +-----------------------------+              holds it along the wall.
//
//     ./moat run examples/05_plan.cpp
//     ./moat run examples/05_plan.cpp --friction 0 --incidence 30
//     ./moat run examples/05_plan.cpp --record RECORD_1.AT2 --record-2 RECORD_2.AT2
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Isolated tower in a moat, in plan"};
  const Length clearance = script.length("clearance", 25 * cm, "free distance to the walls");
  const double friction = script.number("friction", 0.4, "friction coefficient between base and walls, 0 to 1");
  const PlanMotion motion =
      script.plan_motion({near_fault_pulse({.phase = pi / 4}), near_fault_pulse({.phase = -pi / 4}).scaled_by(0.6)})
          .scaled_to_larger_pga(script.acceleration("pga", 0.4 * g, "larger peak of the two components"));

  Model model;
  const auto tower = add(model, PlanBuilding{.outline = rectangle(20 * m, 12 * m),
                                             .storeys = 3,
                                             .floor_mass = 700 * tonne,
                                             .mass_offset = {1 * m, 0.6 * m},
                                             .columns = grid(3, 2, {.stiffness = 100 * MN / m}),
                                             .damping = RayleighDamping{.ratio = 0.05},
                                             .base_mass = 800 * tonne,
                                             .bearings = grid(3, 2,
                                                              LeadRubberBearing{.yield_force = 250 * kN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 2 * MN / m})});
  add(model, PlanMoat{.around = tower.base,
                      .clearance = clearance,
                      .law = ExactHertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                      .friction = friction});

  return script.run(model, motion);
}
