// Tour 3: two isolated buildings side by side, with floors at unequal heights. Read 01_moat_wall.cpp before.
//
//                                    [ floor 5 ]
//                                      |     |
//         [ floor 4 ] <-------gap----->|     |      the lower building's roof meets the column
//           |     |                  [ floor 4 ]    between floors 3 and 4 of the taller one
//           ...                          ...
//         [  base   ] <-------gap---->[  base   ]
//
//     ./moat run examples/03_neighbours.cpp
//     ./moat run examples/03_neighbours.cpp --law hertz_damp --restitution 0.5 --gap "15 cm"
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Two isolated buildings, floors at unequal heights"};
  const Length gap = script.length("gap", 12 * cm, "clearance between the buildings");
  const NamedImpactLaw law{
      .name = script.text("law", "exact_hertz_damp", "impact law (materials/contact/impact_laws.hpp)"),
      .linear_stiffness = 1.8e9 * N / m,
      .hertz_stiffness = 1e10 * N / m_3_2,
      .restitution = script.number("restitution", 0.65, "coefficient of restitution")};
  const GroundMotion motion =
      script.motion(near_fault_pulse()).scaled_to_pga(script.acceleration("pga", 0.4 * g, "peak ground acceleration"));

  Model model;
  const auto low = add(model, ShearBuilding{.name = "low",
                                            .storeys = 4,
                                            .floor_mass = 400 * tonne,
                                            .storey_stiffness = 1 * GN / m,
                                            .damping = {.ratio = 0.05},
                                            .base_mass = 450 * tonne,
                                            .isolation = LeadRubberBearing{.yield_force = 1.3 * MN,
                                                                           .yield_displacement = 1 * cm,
                                                                           .post_yield_stiffness = 20 * MN / m},
                                            .storey_height = 4 * m});
  const auto tall = add(model, ShearBuilding{.name = "tall",
                                             .storeys = 5,
                                             .floor_mass = 500 * tonne,
                                             .storey_stiffness = 1 * GN / m,
                                             .damping = {.ratio = 0.05},
                                             .base_mass = 550 * tonne,
                                             .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                                            .yield_displacement = 1 * cm,
                                                                            .post_yield_stiffness = 19.3 * MN / m},
                                             .storey_height = 4.5 * m,
                                             .x = 10 * m + gap});

  // Bases stand at one height; the roof of the low building, 16 m up, is 2.5 m above floor 3 of the tall one (13.5 m)
  // in a storey of 4.5 m.
  add(model, Gap{.name = "bases", .left = low.base, .right = tall.base, .clearance = gap, .law = law});
  add(model, Gap{.name = "roof against column",
                 .left = low.top(),
                 .right = MemberPoint{tall.floor(3), tall.floor(4), 2.5 / 4.5},
                 .clearance = gap,
                 .law = law});

  return script.run(model, motion);
}
