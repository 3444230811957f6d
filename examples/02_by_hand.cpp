// Tour 2: the building of tour 1, made by hand from nodes and elements. Read 01_moat_wall.cpp before.
//
// ShearBuilding and Moat hide nothing: this script makes the same model, and a test asserts the same peaks.
//
//      floor i  o            One node per floor, with its mass. Between floors a ShearSpring (the storey's
//               | storey i   columns) and two dashpots of Rayleigh damping: the stiffness part in the
//    floor i-1  o            storey, the mass part from every floor to the base, reacting on the base.
//
//     ./moat run examples/02_by_hand.cpp
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Five-storey isolated building inside a moat, by hand"};
  const Length gap = script.length("gap", 10 * cm, "clearance on each side");
  const GroundMotion motion = script.motion(near_fault_pulse({.pulse_period = 1.3 * s}))
                                  .scaled_to_pga(script.acceleration("pga", 0.4 * g, "peak ground acceleration"));

  const int storeys = 5;
  const Mass floor_mass = 500 * tonne;
  const Stiffness storey_stiffness = 1 * GN / m;

  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  std::vector<NodeId> floors;
  for (int i = 1; i <= storeys; ++i)
    floors.push_back(add(model, Node{.name = "floor " + std::to_string(i), .mass = floor_mass, .height = i * 3.5 * m}));

  // 5 % in the first two modes of the superstructure held at its base.
  const std::vector<Mass> masses(storeys, floor_mass);
  const std::vector<Stiffness> stiffnesses(storeys, storey_stiffness);
  const RayleighFactors rayleigh = rayleigh_factors_of_chain(0.05, masses, stiffnesses);

  NodeId below = base;
  for (int i = 1; i <= storeys; ++i) {
    const NodeId floor = floors[static_cast<std::size_t>(i - 1)];
    const std::string number = std::to_string(i);
    add(model, ShearSpring{.name = "storey " + number, .lower = below, .upper = floor, .stiffness = storey_stiffness});
    add(model, ViscousDamper{.name = "storey " + number + " damping",
                             .lower = below,
                             .upper = floor,
                             .damping = rayleigh.stiffness_factor * s * storey_stiffness});
    add(model, ViscousDamper{.name = "floor " + number + " damping",
                             .lower = base,
                             .upper = floor,
                             .damping = rayleigh.mass_factor / s * floor_mass});
    below = floor;
  }
  add(model, LeadRubberBearing{.upper = base,
                               .yield_force = 1.93 * MN,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = 19.3 * MN / m});

  const ExactHertzDamp concrete{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65};
  add(model,
      Gap{.name = "moat left", .place = "moat", .left = ground, .right = base, .clearance = gap, .law = concrete});
  add(model,
      Gap{.name = "moat right", .place = "moat", .left = base, .right = ground, .clearance = gap, .law = concrete});

  // Periods, charts and the base shear need the building.
  add(model, Building{.base = base, .floors = floors});

  return script.run(model, motion);
}
