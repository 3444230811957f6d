// Tour 11: yield force and stiffness of the isolation, in two maps. Read 10_gap_study.cpp before.
//
// Stiff isolation moves less and shakes the building more. Every combination of yield force and post-yield stiffness is
// computed inside a moat; the report maps each response over both.
//
//     ./moat run examples/11_isolator_design.cpp
//     ./moat run examples/11_isolator_design.cpp --gap "30 cm" --out results/narrow
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Yield force and stiffness of the isolation"};
  const Length gap = script.length("gap", 45 * cm, "clearance on each side");
  const GroundMotion motion = script.motion(near_fault_pulse({.pulse_period = 1.8 * s}))
                                  .scaled_to_pga(script.acceleration("pga", 0.35 * g, "PGA"));

  const StudyAxis force{.name = "yield force", .unit = "MN", .values = linearly_spaced(0.5, 4.0, 8)};
  const StudyAxis stiffness{.name = "post-yield stiffness", .unit = "MN/m", .values = linearly_spaced(6.0, 36.0, 7)};
  const StudyResult study = script.study({force, stiffness}, [&](const StudyCase& each) {
    StudyModel one{Model{}, motion};
    const auto building =
        add(one.model, ShearBuilding{.storeys = 5,
                                     .floor_mass = 500 * tonne,
                                     .storey_stiffness = 1 * GN / m,
                                     .damping = {.ratio = 0.05},
                                     .base_mass = 550 * tonne,
                                     .isolation = LeadRubberBearing{
                                         .yield_force = each.value("yield force") * MN,
                                         .yield_displacement = 1 * cm,
                                         .post_yield_stiffness = each.value("post-yield stiffness") * MN / m}});
    add(one.model, Moat{.around = building.base,
                        .clearance = gap,
                        .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});
    return one;
  });

  // The smallest acceleration of the roof without impact.
  const std::vector<double> impacts = study.values("impacts", ""),
                            roof = study.values("absolute_acceleration", "floor 5");
  std::size_t best = impacts.size();
  for (std::size_t i = 0; i < impacts.size(); ++i)
    if (impacts[i] == 0.0 && (best == impacts.size() || roof[i] < roof[best])) best = i;
  char text[200];
  if (best < impacts.size())
    std::snprintf(text, sizeof text, "Least acceleration of the roof without impact: %.2f m/s^2 at %s.", roof[best],
                  StudyCase{study.cases(), best}.description().c_str());
  else
    std::snprintf(text, sizeof text, "Every isolation closes this gap.");
  script.answer(text);
  return script.finish();
}
