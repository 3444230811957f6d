// Tour 1: a five-storey isolated building inside its moat. Start here; then read 02_by_hand.cpp.
//
//            [ floor 5 ]          The building of Zhao, Liu & Li (2017). Under a near-fault pulse it
//               ...               moves further than its gap and hits the wall. The wall is rigid: all
//            [ floor 1 ]          that gives way lies in the stiffness of the contact.
//      wall |<-gap->[ base ]<-gap->| wall
//                   =bearings=
//
//     ./moat run examples/01_moat_wall.cpp
//     ./moat run examples/01_moat_wall.cpp --gap "20 cm"
//     ./moat run examples/01_moat_wall.cpp --record RECORD.AT2 --pga 0.4g
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Five-storey isolated building inside a moat"};
  const Length gap = script.length("gap", 10 * cm, "clearance on each side");
  const GroundMotion motion = script
                                  .motion(near_fault_pulse({.pulse_period = 1.3 * s}))  // --record FILE
                                  .scaled_to_pga(script.acceleration("pga", 0.4 * g, "peak ground acceleration"));

  Model model;
  const auto building =
      add(model, ShearBuilding{.storeys = 5,
                               .floor_mass = 500 * tonne,
                               .storey_stiffness = 1 * GN / m,
                               .damping = RayleighDamping{.ratio = 0.05},
                               .base_mass = 550 * tonne,
                               .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                              .yield_displacement = 1 * cm,
                                                              .post_yield_stiffness = 19.3 * MN / m}});
  add(model, Moat{.around = building.base,
                  .clearance = gap,
                  .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});

  return script.run(model, motion);  // options, analysis, progress, results folder, report
}
