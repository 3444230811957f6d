// A street of isolated buildings in moats, for memory_bounds_test.cpp: ten nodes and two gaps each.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Street"};
  const int buildings = script.integer("buildings", 100, "number of buildings");
  const GroundMotion motion = near_fault_pulse({.pulse_period = 1.3 * s});
  Model model;
  for (int i = 0; i < buildings; ++i) {
    const std::string name = "b" + std::to_string(i);
    const auto building = add(
        model,
        ShearBuilding{.name = name,
                      .storeys = 9,
                      .floor_mass = 500 * tonne,
                      .storey_stiffness = 1 * GN / m,
                      .base_mass = 550 * tonne,
                      .isolation = LeadRubberBearing{
                          .yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 20 * MN / m}});
    add(model, Moat{.name = name + " moat",
                    .around = building.base,
                    .clearance = 10 * cm,
                    .law = HertzDamp{.stiffness = 3e9 * N / m_3_2, .restitution = 0.65}});
  }
  return script.run(model, motion);
}
