// An isolated building between two walls. Replace the values by those of your building.
//
//      wall |<-gap->[ base ]<-gap->| wall      floors above the base, bearings under it
//
// Options of this script: --help after its name. All that can stand here: docs/README.md of moat.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "starter"};
  const Length gap = script.length("gap", 25 * cm, "clearance on each side");
  const GroundMotion motion = script.motion(near_fault_pulse({.pulse_period = 2 * s}));  // --record FILE

  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 3,
                                                 .floor_mass = 400 * tonne,
                                                 .storey_stiffness = 800 * MN / m,
                                                 .damping = RayleighDamping{.ratio = 0.05},
                                                 .base_mass = 450 * tonne,
                                                 .isolation = LeadRubberBearing{.yield_force = 1 * MN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 10 * MN / m},
                                                 .storey_height = 3.5 * m});
  add(model, Moat{.around = building.base,
                  .clearance = gap,
                  .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});

  return script.run(model, motion);
}
